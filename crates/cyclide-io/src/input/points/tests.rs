use super::*;
use cyclide::model::Units;

fn read(text: &str) -> Result<PointTable, String> {
    read_points("p.csv", text.as_bytes(), &PointColumns::default()).map_err(|d| d.to_string())
}

fn xyz(table: &PointTable) -> Vec<Vec<[f64; 3]>> {
    table.contours.iter().map(|c| c.points.iter().map(|p| [p.x, p.y, p.z]).collect()).collect()
}

#[test]
fn a_track_file_gives_its_first_two_columns_and_its_unit() {
    let t = read("# x_m,y_m,w_tr_right_m,w_tr_left_m\n0.96,4.02,7.5,7.3\n4.9,0.98,7.5,7.3\n").unwrap();
    assert_eq!(xyz(&t), [[[0.96, 4.02, 0.0], [4.9, 0.98, 0.0]]]);
    assert_eq!(t.unit_hints, [("x_m".to_owned(), Units::Metre), ("y_m".to_owned(), Units::Metre)]);
    assert_eq!(t.contours[0].offsets, [35, 53]);
}

#[test]
fn an_empty_field_at_the_end_of_a_line_is_no_column() {
    assert_eq!(xyz(&read("x,y\n1,2,\n3,4,,\n").unwrap()), [[[1.0, 2.0, 0.0], [3.0, 4.0, 0.0]]]);
}

#[test]
fn delimiters_line_ends_and_marks_of_the_encoding() {
    for text in [
        "1,2\n3,4\n",
        "1;2\r\n3;4",
        "1\t2\r3\t4\r",
        " 1  2 \n\t3 4\n",
        "\u{feff}x,y\n1,2\n3,4",
        "\"x\",\"y\"\n\"1\",\"2\"\n3, 4",
        "# a remark, of two fields\n1,2 # start\n# between\n3,4\n",
        "\n\n1,2\n3,4\n\n\n",
        "x y\n1 2\n3 4\n",
    ] {
        assert_eq!(xyz(&read(text).unwrap()), [[[1.0, 2.0, 0.0], [3.0, 4.0, 0.0]]], "{text:?}");
    }
}

#[test]
fn columns_are_found_by_name_or_by_position() {
    assert_eq!(xyz(&read("1,2,3\n").unwrap()), [[[1.0, 2.0, 3.0]]]);
    assert_eq!(xyz(&read("1,2,3,4\n").unwrap()), [[[1.0, 2.0, 0.0]]]);
    // The only numbers there are, which is said.
    let only = read("name,a,b,c\nA,1,2,3\n").unwrap();
    assert_eq!((xyz(&only), only.remarks[0].reason), (vec![vec![[1.0, 2.0, 3.0]]], "columns-taken"));
    assert_eq!(xyz(&read("id,Z (mm),Y [mm],X [mm]\n9,3,2,1\n").unwrap()), [[[1.0, 2.0, 3.0]]]);
    assert_eq!(xyz(&read("name,east,north\nA,1,2\n").unwrap()), [[[1.0, 2.0, 0.0]]]);
    assert_eq!(xyz(&read("contour,u,v\n7,1,2\n").unwrap()), [[[1.0, 2.0, 0.0]]]);
    // Names that only begin with the letter are no axes.
    assert_eq!(xyz(&read("year,xylem,x,y\n5,6,1,2\n").unwrap()), [[[1.0, 2.0, 0.0]]]);
    let columns = PointColumns { coordinates: Some(vec!["c".into(), "A".into()]), contour: None };
    assert_eq!(xyz(&read_points("p", b"# a,b,c\n1,2,3\n", &columns).unwrap()), [[[3.0, 1.0, 0.0]]]);
    let columns = PointColumns { coordinates: Some(vec!["3".into(), "2".into()]), contour: None };
    assert_eq!(xyz(&read_points("p", b"1,2,3\n", &columns).unwrap()), [[[3.0, 2.0, 0.0]]]);
}

#[test]
fn contours_by_blank_line_or_by_column() {
    let blank = read("0,0\n1,0\n\n \n5,5\n6,5\n,\n7,7\n").unwrap();
    assert_eq!(blank.contours.iter().map(|c| c.points.len()).collect::<Vec<_>>(), [2, 2, 1]);
    let column = read("contour,x,y\nouter,0,0\nhole,5,5\n\nouter,1,0\n").unwrap();
    assert_eq!(xyz(&column), [vec![[0.0, 0.0, 0.0], [1.0, 0.0, 0.0]], vec![[5.0, 5.0, 0.0]]]);
    let columns = PointColumns { coordinates: None, contour: Some("ring".into()) };
    assert_eq!(read_points("p", b"ring,x,y\n1,0,0\n2,1,1\n", &columns).unwrap().contours.len(), 2);
}

#[test]
fn corners_are_marked_by_a_column() {
    assert_eq!(read("x,y,corner\n0,0,1\n1,0,0\n1,1,1\n").unwrap().contours[0].corners, [0, 2]);
    assert!(read("x,y,corner\n0,0,yes\n").unwrap_err().starts_with("p.csv:2:5: corner must be 0 or 1, not `yes`"));
}

#[test]
fn every_refusal_has_its_place() {
    for (text, start) in [
        ("", "p.csv:1:1: the file has no points"),
        ("# only a remark\n", "p.csv:1:1: the file has no points"),
        ("x,y\n", "p.csv:1:1: the file has no points"),
        ("1,2\n3,abc\n", "p.csv:2:3: `abc` is not a number"),
        ("1,2\n3,nan\n", "p.csv:2:3: `nan` is not a finite number"),
        ("nan,nan\n", "p.csv:1:1: `nan` is not a finite number"),
        ("1,2\n-inf,0\n", "p.csv:2:1: `-inf` is not a finite number"),
        ("1,2\n1e999,0\n", "p.csv:2:1: `1e999` is not a finite number"),
        ("1,2\n3,1e-400\n", "p.csv:2:3: `1e-400` is nearer to 0 than any number that can be read"),
        ("x;y\n1;2\n-0,5E-400;1\n", "p.csv:3:1: `-0,5E-400` is nearer to 0"),
        ("x_m,y_mm\n1,2\n", "p.csv:1:1: the columns x_m, y_mm have different units: write all coordinates in one"),
        ("x_m,y_um\n1,2\n", "p.csv:1:1: the columns x_m, y_um have different units"),
        ("1,2\n3,\n", "p.csv:2:3: a number is missing"),
        ("1,2\n3\n", "p.csv:2:2: the coordinate of column 2 is missing: the line has 1 field; remove"),
        ("1,2\n\n3\n", "p.csv:3:2: the coordinate of column 2 is missing"),
        ("1,2\n3,4,five\n", "p.csv:2:5: the line has 3 fields for 2 columns"),
        ("1.5;2\n1,5;2,5\n", "p.csv:2:1: `1,5` contradicts the numbers before it: the file has decimal commas and"),
        ("1,5;2\n1.5;2,5\n", "p.csv:2:1: `1.5` contradicts the numbers before it"),
        ("1.5;2\n1.234,5;2,5\n", "p.csv:2:1: `1.234,5` is not a number: write it without thousands separators"),
        ("1,5;2\n1,234,567;2\n", "p.csv:2:1: `1,234,567` is not a number: write it without thousands"),
        ("x,y\n\"1,234\",\"5,678\"\n", "p.csv:2:2: `1,234` has either a decimal comma or a thousands separator"),
        ("Nr;x;y\n1;1;2\n2;3;5\nTotal;4;7\n", "p.csv:4:1: `Total` is not the name of a point: remove this line"),
        ("x;y\n1;2\nEnd of file\n", "p.csv:3:1: `End of file` is not a number; remove the line if it is no point"),
        ("1,2\n\"3,4\n", "p.csv:2:1: the quote has no end on this line"),
        ("\"x,y\n1,2\n", "p.csv:1:1: the quote has no end on this line"),
        ("x,y\n1,2\n1,5,2,5\n", "p.csv:3:5: the line has 4 fields for 2 columns; if its commas are decimal, separate"),
        ("5\n6\n", "p.csv:1:1: each line needs two or three coordinates"),
        ("x,y\n1,2\nx,y\n", "p.csv:3:1: the names of the columns are repeated here: remove this line"),
    ] {
        let message = read(text).unwrap_err();
        assert!(message.starts_with(start), "{text:?}: {message}");
    }
    let columns = PointColumns { coordinates: Some(vec!["x_m".into(), "z".into()]), contour: None };
    let error = read_points("p.csv", b"x_m,y_m\n1,2\n", &columns).unwrap_err().to_string();
    assert!(error.starts_with("p.csv:1:1: no column is named `z`; there are x_m, y_m"), "{error}");
    let error = read_points("p.csv", b"1,2\n", &columns).unwrap_err().to_string();
    assert!(error.contains("the file has no header line"), "{error}");
    let columns = PointColumns { coordinates: Some(vec!["x".into()]), contour: None };
    assert!(read_points("p.csv", b"x\n1\n", &columns).unwrap_err().message.contains("1 coordinate columns named"));
}

fn remarks(text: &str) -> Vec<&'static str> {
    read(text).unwrap().remarks.iter().map(|remark| remark.reason).collect()
}

#[test]
fn decimal_commas_are_read_where_commas_separate_nothing_and_it_is_said() {
    for text in ["x;y\n1,5;2,25\n3;4\n", "1,5\t2,25\n3\t4\n", "1,5 2,25\n3 4\n", "\"1,5\",\"2,25\"\n3,4\n"] {
        let table = read(text).unwrap();
        assert_eq!(xyz(&table), [[[1.5, 2.25, 0.0], [3.0, 4.0, 0.0]]], "{text:?}");
        assert_eq!(remarks(text), ["decimal-commas"], "{text:?}");
    }
    // Numbers with points say nothing.
    assert_eq!(remarks("x;y\n1.5;2.25\n3;4\n"), [""; 0]);
}

#[test]
fn a_first_column_that_counts_on_is_named() {
    for (text, found) in [
        ("1 10 20\n2 11 21\n3 13 20\n", true),
        ("0,10,20\n1,11,21\n2,13,20\n", true),
        ("1 10 20\n2 11 21\n4 13 20\n", false),
        ("0.0 10 20\n2.5 11 21\n5.0 13 20\n", true),
        ("0.5 10 20\n3.0 11 21\n5.5 13 20\n", false),
        ("1 10\n2 11\n3 13\n", false),
        ("x y z\n1 10 20\n2 11 21\n3 13 20\n", false),
    ] {
        assert_eq!(remarks(text).contains(&"numbers-as-x"), found, "{text:?}");
        assert_eq!(xyz(&read(text).unwrap())[0].len(), 3);
    }
}

#[test]
fn whole_numbers_that_may_be_pairs_are_named_and_read_as_they_stand() {
    for (text, found) in [
        ("1,5,2,5\n2,5,3,25\n", true),
        ("-1,5,2,5,3,5\n2,5,3,25,0,0\n", true),
        ("1,5,2\n2,25,3\n", true),
        ("1,-5,2\n2,25,3\n", true),
        ("1,-5,2\n2,25,-3\n", false),
        ("1,5\n2,25\n", false),
        ("1,5,2,-5\n", false),
        ("1,5,2,5.0\n", false),
        ("1,5,2,5\n1.5,2,3,4\n", false),
        ("1;5;2;5\n", false),
        ("a,b,c,x,y\n1,5,2,5,6\n", false),
    ] {
        let table = read(text).unwrap();
        assert_eq!(remarks(text).contains(&"decimal-pairs"), found, "{text:?}");
        if found {
            let first = table.contours[0].points[0];
            let written: Vec<f64> = text.lines().next().unwrap().split(',').map(|v| v.parse().unwrap()).collect();
            let third = if written.len() == 3 { written[2] } else { 0.0 };
            assert_eq!(first, Point3::new(written[0], written[1], third));
        }
    }
    // Columns that were asked for are meant.
    let columns = PointColumns { coordinates: Some(vec!["1".into(), "2".into()]), contour: None };
    assert_eq!(read_points("p", b"1,5,2,5\n", &columns).unwrap().remarks, []);
}

#[test]
fn heights_and_layers_that_are_not_read_are_named() {
    for (text, named) in [
        ("x,y,height\n0,0,5\n1,2,6\n", Some("height")),
        ("X_m,Y_m,Elevation_m,id\n0,0,5,1\n", Some("Elevation_m")),
        ("easting;northing;Höhe;layer\n0;0;5;a\n", Some("layer")),
        ("x,y,z,height\n0,0,5,1\n", Some("height")),
        ("x,y,width\n0,0,5\n", None),
        ("x,y,contour\n0,0,5\n", None),
    ] {
        let table = read(text).unwrap();
        let remark = table.remarks.iter().find(|remark| remark.reason == "columns-not-read");
        assert_eq!(remark.is_some(), named.is_some(), "{text:?}");
        let starts = |named: &str| remark.is_some_and(|r| r.message.starts_with(&format!("not read: {named};")));
        assert!(named.is_none_or(starts), "{text:?}: {remark:?}");
    }
}

#[test]
fn names_of_coordinates_are_known_in_many_forms() {
    let expected = [[[1.0, 2.0, 0.0]]];
    for (header, row) in [
        ("X,Y", "1,2"),
        ("id,x_m,y_m", "9,1,2"),
        ("id,easting,northing", "9,1,2"),
        ("id,Northing (m),Easting (m)", "9,2,1"),
        ("POINT_X,POINT_Y,time", "1,2,9"),
        ("t,x coordinate,y coordinate", "9,1,2"),
        ("xcoord,ycoord", "1,2"),
        ("x_mm,y_mm,x_in,z_order_x", "1,2,9,9"),
        ("x,y,x_smooth,y_smooth", "1,2,9,9"),
        ("Rechtswert;Hochwert", "1;2"),
        ("N°;Abscisse;Ordonnée", "9;1;2"),
        ("Nord,Est", "2,1"),
        ("Pkt;Nord;Ost", "9;2;1"),
        ("Punto;Este;Norte;Código", "9;1;2;B"),
        ("Hochwert (X);Rechtswert (Y)", "2;1"),
        ("station,northing,easting", "9,2,1"),
        ("OBJECTID,POINT_X,POINT_Y", "9,1,2"),
        ("#,X,Y", "9,1,2"),
        ("Lfd. Nr.;Punktnummer;X;Y", "9;8;1;2"),
        ("km;x;y", "9;1;2"),
    ] {
        let text = format!("{header}\n{row}\n");
        if header.starts_with("x_mm") {
            // Two units of one coordinate.
            assert!(read(&text).unwrap_err().contains("several columns may be x: x_mm, x_in"));
            continue;
        }
        assert_eq!(xyz(&read(&text).unwrap()), expected, "{header}");
        assert_eq!(remarks(&text), [""; 0], "{header}");
    }
    // Letters that may mean something else, and columns that are only the remaining ones, are said.
    for header in ["id,e,n\n9,1,2\n", "id,foo,bar\n9,1,2\n", "name,u,v\nA,1,2\n", "Nr,H,R\n9,2,1\n", "Nr|H|R\n9|2|1\n"]
    {
        assert_eq!(
            (xyz(&read(header).unwrap()), remarks(header)),
            (expected.map(|l| l.to_vec()).to_vec(), vec!["columns-taken"])
        );
    }
    assert_eq!(remarks("1,2,3.5,4\n"), ["columns-taken"]);
    // A quality is taken for a height, which is said; an accuracy is nothing beside a coordinate.
    let quality = "x,y,z_quality\n1,2,5\n";
    assert_eq!((xyz(&read(quality).unwrap()), remarks(quality)), (vec![vec![[1.0, 2.0, 5.0]]], vec!["columns-taken"]));
    let accuracy = "time,x_acc,y_acc,easting,northing\n0,0.01,0.02,1,2\n";
    assert_eq!(xyz(&read(accuracy).unwrap()), expected);
}

#[test]
fn columns_that_tell_parts_apart_are_used_or_named() {
    let parts = |name: &str| format!("{name},x,y\n1,0,0\n1,1,0\n1,1,1\n2,5,0\n2,6,0\n2,6,1\n");
    assert_eq!(xyz(&read(&parts("contour_id")).unwrap()).len(), 2);
    for name in ["shape", "path_id", "fid", "Kontur", "id"] {
        assert_eq!(remarks(&parts(name)), ["columns-not-read"], "{name}");
    }
    // Letters of the map beside those of the axes.
    let turned = read("Pt,X(N),Y(E)\n1,2,1\n").unwrap();
    assert_eq!(xyz(&turned), [[[1.0, 2.0, 0.0]]]);
    assert_eq!(xyz(&read("Pt,East,North,Up\n1,1,2,3\n").unwrap()), [[[1.0, 2.0, 3.0]]]);
}

#[test]
fn columns_that_could_only_be_guessed_are_refused() {
    for (text, message) in [
        ("a,b,c,d\n1,2,3,4\n", "p.csv:1:1: no column is named x or y; the columns are a, b, c, d: choose two or three"),
        ("lon,lat\n7.1,50.2\n", "p.csv:1:1: lon, lat are geographic angles: project them"),
        ("id,GPSLatitude,GPSLongitude\n1,50.2,7.1\n", "p.csv:1:1: GPSLongitude, GPSLatitude are geographic angles"),
        ("X (Longitude),Y (Latitude)\n7.1,50.2\n", "p.csv:1:1: X (Longitude), Y (Latitude) are geographic angles"),
        ("lat_deg,lon_deg\n50.2,7.1\n", "p.csv:1:1: lon_deg, lat_deg are geographic angles"),
        ("1 1.5 2.5\n2 3.5 2.5\n3 3.5 4.5\n", "p.csv:1:1: column 1 seems to hold point numbers"),
        (
            "station,height,level\n0,1.5,2\n",
            "p.csv:1:1: no column is named x or y; the columns are station, height, level",
        ),
        (
            "km;foo\n1;2\n",
            "p.csv:1:1: no column is named x or y; the columns are km, foo: choose two or three of them, x first (`--columns 1,2`",
        ),
        (
            "merkmal;foo;bar\n1;2,5;3,5\n2;1,5;4\n3;8,5;1,5\n",
            "p.csv:1:1: no column is named x or y; the columns are merkmal, foo, bar: choose two or three of them, x first (`--columns 2,3`",
        ),
        ("easting,foo\n1,2\n", "p.csv:1:1: no column is named x or y"),
        (
            "Nr;Y;X\n1;4500010,5;5334000,1\n2;4500020,5;5334010,1\n",
            "p.csv:1:1: y comes before x, and the coordinates are those of a map grid",
        ),
        (
            "Hz;V;SD\n8,5;47,1;1\n",
            "p.csv:1:1: no column is named x or y; the columns are Hz, V, SD: choose two or three of them, by their names or numbers (`--columns`",
        ),
        ("southing,westing\n1,2\n", "p.csv:1:1: no column is named x or y"),
        ("0 mm,0 mm\n10,5\n", "p.csv:1:1: neither column names nor numbers"),
        ("name,Latitude,Longitude\nA,50.2,7.1\n", "p.csv:1:1: Longitude, Latitude are geographic angles"),
        ("x,x,y\n1,2,3\n", "p.csv:1:1: several columns may be x: x, x; choose"),
        ("x_left,y_left,x_right,y_right\n1,2,3,4\n", "p.csv:1:1: several columns may be x: x_left, x_right"),
        ("x,y,corner,corner\n1,2,0,1\n", "p.csv:1:1: two columns are named `corner`: choose by numbers"),
    ] {
        let error = read(text).unwrap_err();
        assert!(error.starts_with(message), "{text:?}: {error}");
    }
    // Names that nobody asks for may repeat.
    assert_eq!(xyz(&read("x,y,note,note\n1,2,3,4\n").unwrap()), [[[1.0, 2.0, 0.0]]]);
    for (names, message) in [
        (["1", "1"], "the column x is chosen twice"),
        (["x", "1"], "the column x is chosen twice"),
        (["note", "y"], "two columns are named `note`: choose by numbers"),
    ] {
        let columns = PointColumns { coordinates: Some(names.map(str::to_owned).to_vec()), contour: None };
        let error = read_points("p", b"x,y,note,note\n1,2,3,4\n", &columns).unwrap_err().message;
        assert!(error.starts_with(message), "{names:?}: {error}");
    }
    let columns = PointColumns { coordinates: Some(vec!["lon".into(), "lat".into()]), contour: None };
    assert!(read_points("p", b"lon,lat\n1,2\n", &columns).is_ok(), "who asks for them gets them");
}

#[test]
fn blank_lines_after_every_point_separate_nothing() {
    let text = "x,y,corner\n\n0,0,0\n\n1,0,1\n\n1,1,0\n\n";
    let table = read(text).unwrap();
    assert_eq!(xyz(&table), [[[0.0, 0.0, 0.0], [1.0, 0.0, 0.0], [1.0, 1.0, 0.0]]]);
    assert_eq!((&table.contours[0].corners[..], remarks(text)), (&[1][..], vec!["blank-lines"]));
    assert_eq!(table.contours[0].offsets.len(), 3);
    assert_eq!(read("0,0\n\n1,0\n2,0\n").unwrap().contours.len(), 2);
}

#[test]
fn quotes_count_at_the_start_of_a_field() {
    let table = read("name,x,y\n5\" pipe,1,2\n\"a, \"\"b\"\" # c\",3,4 # \"remark\n").unwrap();
    assert_eq!(xyz(&table), [[[1.0, 2.0, 0.0], [3.0, 4.0, 0.0]]]);
}

#[test]
fn the_unit_is_found_at_the_beginning_of_a_file() {
    let unit = |text: &str| unit_of_columns(text.as_bytes(), &PointColumns::default()).map(|found| found.unit);
    assert_eq!(unit("# x_m,y_m\n1,2\n3,é"), Some(Units::Metre));
    assert_eq!(unit("name,x [ft],y [ft],z_m_note\nA,1,2,3\n"), Some(Units::Foot));
    assert_eq!(unit("x_inch,y (in)\n1,2\n"), Some(Units::Inch));
    assert_eq!(unit("x_feet,y_ft\n1,2\n"), Some(Units::Foot));
    assert_eq!(unit("x_um,y_um\n1,2\n"), None);
    assert_eq!(unit("x_m,y_mm\n1,2\n"), None);
    assert_eq!(unit("x,y\n1,2\n"), None);
    assert_eq!(unit(""), None);
    let mut cut = b"x_m,y_m\n1,2\n3,\xc3".to_vec();
    assert!(unit_of_columns(&cut, &PointColumns::default()).is_some(), "a character cut in two");
    cut.clear();
    assert!(unit_of_columns(&cut, &PointColumns::default()).is_none());
}

#[test]
fn a_unit_that_models_do_not_have_is_said_and_not_applied() {
    for header in ["x_um,y_um", "x [km],y [km]", "easting (mi),northing (mi)"] {
        let text = format!("{header}\n1,2\n");
        let table = read(&text).unwrap();
        assert_eq!((xyz(&table), remarks(&text)), (vec![vec![[1.0, 2.0, 0.0]]], vec!["unit-not-applied"]), "{header}");
        let message = &table.remarks[0].message;
        assert!(message.starts_with(&format!("the columns {} name a unit", header.replace(',', ", "))), "{message}");
        assert!(table.unit_hints.is_empty());
    }
    assert_eq!(remarks("x,y,speed_km\n1,2,3\n"), [""; 0], "a column that is not read");
    // Zero in any form is one.
    assert_eq!(xyz(&read("0e-400,-0.00\n0,1e-300\n").unwrap()), [[[0.0, -0.0, 0.0], [0.0, 1e-300, 0.0]]]);
}

#[test]
fn lines_and_fields_of_any_length_are_refused_and_quoted_in_part() {
    for (text, message) in [
        ("7".repeat(30_000_000), "p.csv:1:1: the line has 30000000 bytes, maximum 65536"),
        ("1,".repeat(15_000_000), "p.csv:1:1: the line has 30000000 bytes"),
        (format!("1,2\n{}\n", "1,".repeat(15_000_000)), "p.csv:2:1: the line has 30000000 bytes"),
        (format!("1,{}x\n", "7".repeat(60_000)), "p.csv:1:3: `7777777"),
        (format!("x,{}\n1,2,3\n", "y".repeat(60_000)), "p.csv:2:5: the line has 3 fields for 2 columns"),
        (format!("a,{},c,d\n1,2,3,4\n", "y".repeat(60_000)), "p.csv:1:1: no column is named x or y"),
    ] {
        let error = read(&text).unwrap_err();
        assert!(error.starts_with(message), "{error}");
        assert!(error.len() < 700, "{error}");
    }
}

#[test]
fn what_the_points_are_called_is_kept() {
    for (text, called) in [
        ("Nr;x;y\nB1;1;2\nB2;3;4\n", &["B1", "B2"][..]),
        ("A 1.5 2\nB 3 4\n", &["A", "B"]),
        ("x,y,name\n1,2,left\n3,4,\n", &["left", ""]),
        ("km;x;y\n1;1;2\n2;3;4\n", &[]),
        ("x,y\n1,2\n", &[]),
    ] {
        let table = read(text).unwrap();
        let list = &table.contours[0];
        let labels: Vec<&str> = list.labels.iter().map(|range| &text[range.clone()]).collect();
        assert_eq!(labels, called, "{text:?}");
    }
    let notes = read("N°;Abscisse;Ordonnée\n1;1,5;2\n").unwrap().notes;
    assert_eq!(notes, ["x is `Abscisse`, y is `Ordonnée`, the names of the points are in `N°`"]);
    assert_eq!(read("x_m,y_m\n1,2\n").unwrap().notes, [""; 0]);
}

#[test]
fn heights_are_read_beside_coordinates_of_maps() {
    for text in [
        "Point,Northing,Easting,Elevation\n7,2,1,3\n",
        "Punkt;Rechtswert;Hochwert;Höhe\nP7;1;2;3\n",
        "Punto;Este;Norte;Cota\n7;1;2;3\n",
        "Punto;Est;Nord;Quota\n7;1;2;3\n",
        "N°;Abscisse;Ordonnée;Altitude\n7;1;2;3\n",
        "E,N,RL\n1,2,3\n",
    ] {
        assert_eq!(xyz(&read(text).unwrap()), [[[1.0, 2.0, 3.0]]], "{text:?}");
    }
}

#[test]
fn tables_as_spreadsheets_write_them() {
    let expected = [[[1234.5, 2.25, 0.0], [1300.0, 1000.0, 0.0]]];
    for text in [
        "sep=;\nNr;X;Y\n1;1.234,5;2,25\n2;1.300;1.000\n",
        "Aufmaß Hof\n;;\nNr;X;Y\n;[m];[m]\n1;1234,5;2,25\n2;1300;1000\n;;\n",
        "Nr,X,Y\n1,\"1,234.5\",2.25\n2,\"1,300\",\"1,000\"\n",
        "Nr;X;Y\n1;1'234.5;2.25\n2;1'300;1'000\n",
        "Nr;X;Y\n1;1 234,5;2,25\n2;1 300;1 000\n",
        "Nr\tX\tY\n1\t1\u{a0}234,5\t2,25\n2\t1\u{a0}300\t1\u{a0}000\n",
        "P1 1234,5 2,25\nP2 1300 1000\n",
    ] {
        assert_eq!(xyz(&read(text).unwrap()), expected, "{text:?}");
    }
    let units = read("Nr;X;Y\n;[m];[m]\n1;1,5;2\n").unwrap().unit_hints;
    assert_eq!(units, [("X".to_owned(), Units::Metre), ("Y".to_owned(), Units::Metre)]);
    let latin = b"N\xb0;Abscisse;Ordonn\xe9e\n1;1234,5;2,25\n2;1300;1000\n";
    let table = read_points("p.csv", latin, &PointColumns::default()).unwrap();
    assert_eq!(xyz(&table), expected);
    assert_eq!(table.notes.last().unwrap(), "the text is read as Windows-1252 (Latin-1)");
}

#[test]
fn coordinates_that_look_like_those_of_a_grid_are_said_without_a_unit() {
    for (text, said) in [
        ("Easting,Northing\n334000.5,5334000.25\n334010,5334020\n", true),
        ("x_m,y_m\n334000.5,5334000.25\n334010,5334020\n", false),
        ("x,y\n0,0\n150000,20000\n", false),
        ("x,y\n1,2\n3,4\n", false),
    ] {
        assert_eq!(remarks(text).contains(&"units-assumed"), said, "{text:?}");
    }
}

#[test]
fn a_line_of_units_may_say_what_heights_are_over() {
    for over in ["m", "m ü. NHN", "m ü. M.", "m a.s.l.", "m s.l.m.", "m NGF IGN69", "[m über Adria]"] {
        let table = format!("Nr.;Ost;Nord;Höhe\n-;m;m;{over}\n1;4.5;5.5;3.1\n2;5.5;6.5;3.2\n");
        assert_eq!(xyz(&read(&table).unwrap()), [[[4.5, 5.5, 3.1], [5.5, 6.5, 3.2]]], "{over}");
    }
    assert!(read("Nr.;Ost;Nord;Höhe\n-;m;m;m high\n1;4.5;5.5;3.1\n").is_err());
}

#[test]
fn heights_that_stand_for_none_are_refused_or_said() {
    let table = |heights: &str| {
        let rows = heights.split(' ').enumerate().map(|(i, z)| format!("{i}.5,{},{z}\n", i * i));
        format!("x,y,z\n{}", rows.collect::<String>())
    };
    for (heights, line) in [
        ("100 101.5 -9999 102", 4),
        ("-9999.0 1 2 3 -9999 4", 2),
        ("1 2 3 99999", 5),
        ("1 2 3 -32768", 5),
        ("1 2 3 -3.4028235e38", 5),
        ("200 220 9999.99 210", 4),
    ] {
        let message = read(&table(heights)).unwrap_err();
        assert!(message.starts_with(&format!("p.csv:{line}:1: ")), "{heights}: {message}");
        assert!(message.contains("`--columns 1,2`"), "{heights}: {message}");
    }
    for (heights, said) in [
        ("100 101 0 102", true),
        ("100 101 0 103 102 0", true),
        ("1 2 3 999", true),
        ("200 221 0 210", true),
        ("5 5 5 0", false),
    ] {
        assert_eq!(remarks(&table(heights)).contains(&"heights-missing"), said, "{heights}");
    }
    // Depths and mountains, levels, and what is typed.
    for heights in [
        "-9999 -9000 -8000",
        "9990 9999 10010 9980",
        "0 1 2 3 0",
        "0 -2 -2 -2 0",
        "-9999 -9999 -9999",
        "100 0 102 0 0 0",
    ] {
        assert!(read(&table(heights)).is_ok() && !remarks(&table(heights)).contains(&"heights-missing"), "{heights}");
    }
    let typed =
        PointColumns { coordinates: Some(["x", "y", "z"].map(str::to_owned).to_vec()), ..PointColumns::default() };
    assert!(read_points("p.csv", table("100 101 -9999 102").as_bytes(), &typed).is_ok());
}

#[test]
fn names_of_several_words_do_not_move_columns() {
    let rows = "1  4.5  5.5  3.1\n2  5.5  6.5  3.2\n";
    let right = [[[4.5, 5.5, 3.1], [5.5, 6.5, 3.2]]];
    for header in ["Punkt Nr  Ost  Nord  Höhe", "Pt No  Easting  Northing  RL", "Point ID   E   N   Ground level"] {
        assert_eq!(xyz(&read(&format!("{header}\n{rows}")).unwrap()), right, "{header}");
    }
    let text = format!("Punkt Nr Ost Nord Höhe\n{rows}");
    let message = read(&text).unwrap_err();
    assert!(message.starts_with("p.csv:1:1: there are 5 names for 4 columns"), "{message}");
    let columns =
        PointColumns { coordinates: Some(["2", "3", "4"].map(str::to_owned).to_vec()), ..PointColumns::default() };
    assert_eq!(xyz(&read_points("p.csv", text.as_bytes(), &columns).unwrap()), right);
    // A column that some rows end before.
    assert_eq!(xyz(&read("x y z code\n4.5 5.5 3.1\n5.5 6.5 3.2 A\n").unwrap()), right);
}
