use super::*;

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
    assert_eq!(xyz(&read("a,b,c\n1,2,3\n").unwrap()), [[[1.0, 2.0, 0.0]]]);
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
        ("", "p.csv:1:1: the file holds no points"),
        ("# only a remark\n", "p.csv:1:1: the file holds no points"),
        ("x,y\n", "p.csv:1:1: the file holds no points"),
        ("1,2\n3,abc\n", "p.csv:2:3: `abc` is not a number"),
        ("1,2\n3,nan\n", "p.csv:2:3: `nan` is not a finite number"),
        ("nan,nan\n", "p.csv:1:1: `nan` is not a finite number"),
        ("1,2\n-inf,0\n", "p.csv:2:1: `-inf` is not a finite number"),
        ("1,2\n1e999,0\n", "p.csv:2:1: `1e999` is not a finite number"),
        ("1,2\n3,\n", "p.csv:2:3: a number is missing"),
        ("1,2\n3\n", "p.csv:2:2: the coordinate of column 2 is missing: the line has 1 fields"),
        ("1,2\n\n3\n", "p.csv:3:2: the coordinate of column 2 is missing"),
        ("x,y\n1,2\n1,5,2,5\n", "p.csv:3:5: the line has 4 fields for 2 columns"),
        ("1,2\n3,4,five\n", "p.csv:2:5: the line has 3 fields for 2 columns"),
        ("1;2\n1,5;2,5\n", "p.csv:2:1: `1,5` is not a number: use a decimal point"),
        ("5\n6\n", "p.csv:1:1: two or three coordinates are needed in each line"),
        ("x,y\n1,2\nx,y\n", "p.csv:3:1: `x` is not a number"),
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

#[test]
fn units_are_read_from_names() {
    for (name, unit) in [
        ("x_m", Some(Units::Metre)),
        ("x [mm]", Some(Units::Millimetre)),
        ("x_in", Some(Units::Inch)),
        ("X (ft)", Some(Units::Foot)),
        ("x/cm", Some(Units::Centimetre)),
        ("x", None),
        ("m", None),
        ("x_left", None),
    ] {
        assert_eq!(unit_in_name(name), unit, "{name}");
    }
}
