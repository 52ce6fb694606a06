//! Coordinates by names and figures, and what refusals offer.

use super::super::{PointColumns, PointTable, read_points};

fn read(text: &str) -> Result<PointTable, String> {
    read_points("p.csv", text.as_bytes(), &PointColumns::default()).map_err(|d| d.message)
}

fn first(table: &PointTable) -> [f64; 3] {
    table.contours[0].points[0].to_array()
}

fn remark(table: &PointTable, reason: &str) -> String {
    table.remarks.iter().find(|r| r.reason == reason).map(|r| r.message.clone()).unwrap_or_default()
}

/// The columns of each command that a message offers.
fn offered(message: &str) -> Vec<Vec<String>> {
    let column = |rest: &str| rest.split('`').next().unwrap_or_default().split(',').map(str::to_owned).collect();
    message.split("--columns ").skip(1).map(column).collect()
}

#[test]
fn one_height_is_read_and_of_several_none_is_lost_in_silence() {
    for name in [
        "Ell.Höhe",
        "Geländehöhe",
        "NHN",
        "DHHN2016",
        "Orthometric",
        "Kote",
        "Rzędna",
        "Wysokość",
        "GOK",
        "Hell",
        "Höhe H",
    ] {
        let table = read(&format!("Nr;East [m];North [m];{name}\n1;10;20;3\n2;11;21;3.5\n")).unwrap();
        assert_eq!((first(&table), &table.remarks[..]), ([10.0, 20.0, 3.0], &[][..]), "{name}");
    }
    // The letter of local systems, and heights that may be those of something else, are said.
    for header in ["Nr;E;N;U", "Nr;Easting;Northing;Deckenhöhe", "Nr;Easting;Northing;Soll Höhe"] {
        let table = read(&format!("{header}\n1;10;20;3\n2;11;21;3.5\n")).unwrap();
        assert_eq!((first(&table), remark(&table, "columns-taken").is_empty()), ([10.0, 20.0, 3.0], false), "{header}");
    }
    // Of two the one over the sea; of two alike none, and both are offered.
    let sea =
        read("Pt,Northing,Easting,WGS84 Ellipsoidal Height (m),Elevation (m)\n1,20,10,59.7,12.5\n2,21,11,59.9,12.7\n")
            .unwrap();
    assert_eq!(first(&sea).to_vec(), [10.0, 20.0, 12.5]);
    assert_eq!(offered(&remark(&sea, "columns-not-read")), [["3", "2", "4"]]);
    let two = read("Pt,Easting,Northing,Elevation,Altitude\n1,10,20,59.7,12.5\n2,11,21,59.9,12.7\n").unwrap();
    assert_eq!(first(&two).to_vec(), [10.0, 20.0, 0.0]);
    assert_eq!(offered(&remark(&two, "columns-not-read")), [["2", "3", "4"], ["2", "3", "5"]]);
    // Nothing stands in the column.
    assert_eq!(read("Nr;E [m];N [m];Höhe\n1;10;20;\n2;11;21;\n").unwrap().remarks.len(), 1);
}

#[test]
fn numbers_that_may_be_of_the_shape_are_named_and_others_are_not() {
    for (header, row, named) in [
        ("x,y,Radius [m]", ["0,0,", "5,0,50"], Some("Radius [m]")),
        ("x,y,thickness", ["0,0,1.5", "5,0,2.5"], Some("thickness")),
        ("x,y,foo [mm]", ["0,0,1.5", "5,0,1.5"], Some("foo [mm]")),
        ("x,y,foo", ["0,0,0", "5,0,0"], None),
        ("Point ID,x,y,code,time", ["1,0,0,A,1.5", "2,5,0,B,2.5"], None),
        ("x,y,sx,sy,hdop,Height SD", ["0,0,1,1,1,1", "5,0,2,1,2,1"], None),
        ("x,y,w_right_m", ["0,0,5", "5,0,5"], None),
        ("x,y,w_tr_right_m,w_tr_left_m", ["0,0,7.5,7.3", "5,0,7.4,7.2"], None),
        ("x,y,z,tangent_x,curvature", ["0,0,1,1,0.1", "5,0,1,0.9,0.2"], None),
        ("x,y,remark", ["0,0,a", "5,0,b"], None),
    ] {
        let table = read(&format!("{header}\n{}\n{}\n", row[0], row[1])).unwrap();
        let message = remark(&table, "columns-not-read");
        assert_eq!(message.strip_prefix("not read: ").and_then(|m| m.split(';').next()), named, "{header}: {message}");
    }
    // An arc is refused, and its chord has to be asked for.
    let bulges = "x,y,bulge\n0,0,0\n100,0,0.41421356\n120,20,0\n";
    let refused = read_points("p.csv", bulges.as_bytes(), &PointColumns::default()).unwrap_err().to_string();
    assert!(refused.starts_with("p.csv:3:7: an arc with the bulge 0.41421356"), "{refused}");
    let columns = PointColumns { coordinates: Some(offered(&refused).remove(0)), ..PointColumns::default() };
    assert_eq!(read_points("p.csv", bulges.as_bytes(), &columns).unwrap().contours[0].points.len(), 3);
    assert!(read("x,y,bulge\n0,0,0\n100,0,0\n").is_ok());
}

#[test]
fn a_northing_that_stands_first_is_refused_with_both_commands() {
    for (text, commands) in [
        ("5432000 456000 412\n5432010 456020 413\n", [["2", "1", "3"], ["1", "2", "3"]]),
        ("Nr;X;Y\n1;5432000,5;456000,5\n2;5432010,5;456020,5\n", [["3", "2", ""], ["2", "3", ""]]),
        ("Nr;X;Y;Z\n1;5.432.000,5;3.456.000,5;9\n2;5.432.010,5;3.456.020,5;9\n", [["3", "2", "4"], ["2", "3", "4"]]),
        ("a;b\n5432000,5;32456000,5\n5432010,5;32456020,5\n", [["2", "1", ""], ["1", "2", ""]]),
    ] {
        let commands = commands.map(|command| command.into_iter().filter(|c| !c.is_empty()).collect::<Vec<_>>());
        let refused = read(text).unwrap_err();
        assert_eq!(offered(&refused), commands, "{text}: {refused}");
        let coordinates = Some(offered(&refused).remove(0));
        let columns = PointColumns { coordinates, ..PointColumns::default() };
        let table = read_points("p.csv", text.as_bytes(), &columns).unwrap();
        assert!(first(&table)[1] > 5.4e6 && first(&table)[1] < 5.5e6, "{text}");
    }
    // Names say more than figures, and an easting that stands first is right.
    let named = read("N_UTM,E_UTM\n5432000,456000\n5432010,456020\n").unwrap();
    assert_eq!(first(&named).to_vec(), [456_000.0, 5_432_000.0, 0.0]);
    for text in ["456000 5432000 412\n456020 5432010 413\n", "X;Y\n3456000;5432000\n3456020;5432010\n"] {
        assert!(read(text).is_ok(), "{text}");
    }
}

#[test]
fn letters_of_the_map_beside_the_name_of_a_system_are_known() {
    for header in ["MTM_N;MTM_E", "N MTM9;E MTM9", "N_LV95;E_LV95", "Northing;Easting", "P;M"] {
        let table = read(&format!("Nr.;{header};H\n1;900.5;545.5;100\n2;906.5;543.5;101\n")).unwrap();
        assert_eq!(first(&table).to_vec(), [545.5, 900.5, 100.0], "{header}");
    }
    // The `H` of a Hochwert is no height, and takes the place of none.
    for header in ["GK_H;GK_R;Elev", "Hochwert;Rechtswert;H", "H;R;Elev"] {
        let table = read(&format!("Nr.;{header}\n1;900.5;545.5;100\n2;906.5;543.5;101\n")).unwrap();
        assert_eq!(first(&table).to_vec(), [545.5, 900.5, 100.0], "{header}");
    }
    // A radius and a height have the same letters, and no name of a system beside them: the only numbers, which is said.
    let pipe = read("Nr;Rohr_H;Rohr_R\n1;0.5;2.5\n2;0.6;2.7\n").unwrap();
    assert_eq!((first(&pipe), remark(&pipe, "columns-taken").is_empty()), ([0.5, 2.5, 0.0], false));
    // Accuracies and differences are no coordinates.
    let table = read("Point,Easting,Northing,Delta E,Delta N\n1,10,20,0.1,0.2\n2,11,21,0.2,0.1\n").unwrap();
    assert_eq!(first(&table).to_vec(), [10.0, 20.0, 0.0]);
}

#[test]
fn what_a_refusal_offers_can_be_typed() {
    for text in [
        "Pt,Local E,Local N,Local H,Grid E,Grid N,Grid H\n1,6.5,2,3,16.5,12,3\n2,7.5,2,3,17.5,12,3\n",
        "Pt,Design E,Design N,Measured E,Measured N\n1,6.5,2,16.5,12\n2,7.5,2,17.5,12\n",
        "x_left,y_left,x_right,y_right\n1,2,3,4\n2,2,3,4\n",
        "x,x,y\n1,2,3\n2,3,4\n",
        "a,b,c,d\n1,2,3,4\n",
    ] {
        let refused = read(text).unwrap_err();
        let commands = offered(&refused);
        assert!(!commands.is_empty(), "{refused}");
        for coordinates in commands {
            let columns = PointColumns { coordinates: Some(coordinates), ..PointColumns::default() };
            assert!(read_points("p.csv", text.as_bytes(), &columns).is_ok(), "{text}: {columns:?}");
        }
    }
    let local = read("Pt,Local E,Local N,Local H,Grid E,Grid N,Grid H\n1,6.5,2,3,16.5,12,3\n").unwrap_err();
    assert_eq!(offered(&local), [["2", "3", "4"], ["5", "6", "7"]]);
    // No height is there: the points are asked for in the plane.
    let text = "Nr;Rechtswert;Hochwert;Höhe\n1;1,5;2,5;3\n2;3,5;4;\n";
    assert_eq!(offered(&read(text).unwrap_err()), [["2", "3"]]);
}

#[test]
fn coordinates_beside_angles_on_the_globe_are_read() {
    for (text, expected) in [
        (
            "Point ID,Northing,Easting,Elevation,Latitude,Longitude\n1,20,10,5,49.1,8.1\n2,21,11,5,49.2,8.2\n",
            [10.0, 20.0, 5.0],
        ),
        ("id,lat,lon,x,y\n0,48.1,11.5,45.5,7\n1,48.1,11.5,43.5,8\n", [45.5, 7.0, 0.0]),
    ] {
        let table = read(text).unwrap();
        assert_eq!((first(&table), &table.remarks[..]), (expected, &[][..]), "{text}");
        assert!(
            table.notes.iter().any(|note| note.ends_with("are geographic angles and are ignored")),
            "{:?}",
            table.notes
        );
    }
    assert!(read("name,Latitude,Longitude\nA,50.2,7.1\n").unwrap_err().contains("geographic angles"));
}

#[test]
fn codes_whose_points_are_far_apart_are_named() {
    let table = |gap: f64| {
        let row = |code: &str, from: f64| {
            (0..4).map(|k| format!("{},{},{code}\n", from + f64::from(k), 2 * k)).collect::<String>()
        };
        format!("E_m,N_m,Code\n{}{}", row("KL", 0.0), row("KR", gap))
    };
    let far = remark(&read(&table(300.0)).unwrap(), "columns-not-read");
    assert!(far.starts_with("not read: Code;") && far.contains("--contour-column \"Code\""), "{far}");
    assert_eq!(remark(&read(&table(4.0)).unwrap(), "columns-not-read"), "");
}
