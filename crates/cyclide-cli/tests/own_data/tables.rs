//! Tables as surveyors, robots and spreadsheets write them.
//!
//! The points are known before the tables are written, in whatever dialect: what is read back is these points, or the table is
//! refused with the command that reads it.

use cyclide_io::input::{PointColumns, PointTable, read_points};

use crate::case;
use crate::common::Folder;

/// The points of `survey_fr.csv` lie on an ellipse with half axes 50 and 30, whose circumference is this, to the millimeter
/// that they are written to and what a smooth curve through 24 of them leaves.
const SURVEY_LENGTH: f64 = 255.27;

#[test]
fn a_french_survey_has_its_length_and_lies_in_a_plane() {
    let folder = Folder::with(&[("survey_fr.csv", &case("survey_fr.csv"))]);
    let run = folder.run("curve survey_fr.csv --closed --json -o curve.json");
    assert_eq!(run.code, 0, "{}", run.stderr);
    let report: serde_json::Value = serde_json::from_str(&run.stdout).unwrap();
    let object = &report["objects"]["survey_fr"];
    assert!((object["length"].as_f64().unwrap() - SURVEY_LENGTH).abs() < 5e-3, "{object}");
    assert!(
        run.stderr.contains("x is `Abscisse`, y is `Ordonnée`, the names of the points are in `N°`"),
        "{}",
        run.stderr
    );
    let points = read_points("survey_fr.csv", case("survey_fr.csv").as_bytes(), &PointColumns::default()).unwrap();
    assert!(points.contours[0].points.iter().all(|p| p.z.abs() <= 0.0));
}

#[test]
fn a_document_reads_a_table_as_the_command_does() {
    let folder = Folder::with(&[
        ("survey_fr.csv", &case("survey_fr.csv")),
        (
            "model.json",
            r#"{"cyclide": 1, "objects": {"survey_fr": {"type": "fair-spline", "closed": true, "points": {"csv": "survey_fr.csv"}}}}"#,
        ),
    ]);
    let of_command = folder.json("curve survey_fr.csv --closed --json -o curve.step");
    let of_document = folder.json("report model.json --json");
    for field in ["length", "notes"] {
        let (a, b) = (&of_command["objects"]["survey_fr"][field], &of_document["objects"]["survey_fr"][field]);
        assert!(!a.is_null() && a == b, "{field}: {a} {b}");
    }
}

/// Point numbers name the points where messages speak of them.
#[test]
fn a_point_is_named_as_the_person_does() {
    let text = "Pkt;Rechtswert;Hochwert\nB11;1,5;2\nB12;4,5;2\nB13;4,5;2\nB14;7;9\n";
    let folder = Folder::with(&[("points.csv", text)]);
    let run = folder.run("curve points.csv --json -o curve.step");
    assert!(run.stderr.contains("points.csv:4 (`B13`)"), "{}", run.stderr);
    assert!(run.stdout.contains("points.csv:4 (`B13`)"), "{}", run.stdout);
}

/// Pictures write beside a point what its table calls it.
#[test]
fn pictures_name_the_points() {
    let folder = Folder::with(&[("survey_fr.csv", &case("survey_fr.csv"))]);
    folder.ok("curve survey_fr.csv --closed -o plain.png");
    folder.ok("curve survey_fr.csv --closed -o named.png --labels");
    assert_ne!(folder.read("plain.png"), folder.read("named.png"));
}

/// US survey feet are 1200/3937 m, and files say so.
#[test]
fn us_survey_feet_are_a_unit() {
    let folder = Folder::with(&[("p.csv", "Point,Easting (ftUS),Northing (ftUS)\n1,0,0\n2,3937,0\n3,5000,100\n")]);
    let run = folder.run("curve p.csv -o c.step -o c.dxf");
    assert!(run.code == 0 && run.stderr.contains("the unit is us-ft"), "{}", run.stderr);
    let step = String::from_utf8(folder.read("c.step")).unwrap();
    let factor = step.split("LENGTH_MEASURE_WITH_UNIT(LENGTH_MEASURE(").nth(1).unwrap().split(')').next().unwrap();
    assert!((factor.parse::<f64>().unwrap() * 3937.0 - 1_200_000.0).abs() < 1e-9, "{factor}");
    let dxf = String::from_utf8(folder.read("c.dxf")).unwrap();
    assert!(dxf.contains("$INSUNITS\n 70\n21\n") || dxf.contains("$INSUNITS\n 70\n    21\n"), "code 21 of DXF");
}

/// `poses_euroc.csv`: dates in nanoseconds half a second apart, on a circle of radius 1 m that rises by 0.05 m a pose.
#[test]
fn poses_of_data_sets_and_robots_are_read() {
    let euroc = case("poses_euroc.csv");
    let poses: Vec<Vec<&str>> = euroc.lines().skip(1).map(|line| line.split(',').collect()).collect();
    let motion = |name: &str, more: &str| {
        format!(
            r#"{{"cyclide": 1, "units": "m", "objects": {{"m": {{"type": "motion", "poses": {{"csv": "{name}"{more}}}}}}}}}"#
        )
    };
    // x y z, then w x y z of the quaternion.
    let rows = |order: &[usize], separator: &str, time: &dyn Fn(usize) -> String| -> String {
        let row = |(i, pose): (usize, &Vec<&str>)| {
            let fields: Vec<&str> = order.iter().map(|&k| pose[k]).collect();
            format!("{}{separator}{}\n", time(i), fields.join(separator))
        };
        poses.iter().enumerate().map(row).collect()
    };
    let stamp = |i: usize| poses[i][0].to_owned();
    let seconds = |i: usize| format!("{}", 0.5 * i as f64);
    let first = [1, 2, 3, 4, 5, 6, 7];
    let last = [1, 2, 3, 5, 6, 7, 4];
    let ros = "%time,field.header.seq,field.header.stamp,field.header.frame_id,field.pose.position.x,field.pose.position.y,field.pose.position.z,\
               field.pose.orientation.x,field.pose.orientation.y,field.pose.orientation.z,field.pose.orientation.w\n";
    let ros_rows: String =
        rows(&last, ",", &|i| format!("{},{i},{},map", 1_403_636_590_000_000_000_i64 + i as i64, stamp(i)));
    let kitti: String = poses
        .iter()
        .map(|pose| {
            let v: Vec<f64> = pose[1..].iter().map(|v| v.parse().unwrap()).collect();
            let (w, x, y, z) = (v[3], v[4], v[5], v[6]);
            let rows = [
                [1.0 - 2.0 * (y * y + z * z), 2.0 * (x * y - w * z), 2.0 * (x * z + w * y), v[0]],
                [2.0 * (x * y + w * z), 1.0 - 2.0 * (x * x + z * z), 2.0 * (y * z - w * x), v[1]],
                [2.0 * (x * z - w * y), 2.0 * (y * z + w * x), 1.0 - 2.0 * (x * x + y * y), v[2]],
            ];
            rows.iter().flatten().map(|v| format!("{v:.9e}")).collect::<Vec<_>>().join(" ") + "\n"
        })
        .collect();
    let vectors: String = poses
        .iter()
        .enumerate()
        .map(|(i, pose)| {
            let v: Vec<f64> = pose[1..].iter().map(|v| v.parse().unwrap()).collect();
            let length = (v[4] * v[4] + v[5] * v[5] + v[6] * v[6]).sqrt();
            let factor = 2.0 * length.atan2(v[3]) / length;
            let [x, y, z] = [v[4], v[5], v[6]].map(|part| part * factor);
            format!("{},{},{},{},{x},{y},{z}\n", 0.5 * i as f64, v[0], v[1], v[2])
        })
        .collect();
    let duration = 0.5 * (poses.len() - 1) as f64;
    let mut lengths = Vec::new();
    for (name, table, more, timed) in [
        ("euroc.csv", euroc.clone(), "", true),
        ("tum.txt", rows(&last, " ", &seconds), "", true),
        (
            "remark.txt",
            format!("# a trajectory\n# timestamp tx ty tz qx qy qz qw\n{}", rows(&last, " ", &seconds)),
            "",
            true,
        ),
        ("ros.csv", ros.to_owned() + &ros_rows, "", true),
        ("kitti.txt", kitti, "", false),
        (
            "ur.csv",
            format!(
                "timestamp,actual_TCP_pose_0,actual_TCP_pose_1,actual_TCP_pose_2,actual_TCP_pose_3,actual_TCP_pose_4,actual_TCP_pose_5\n{vectors}"
            ),
            "",
            true,
        ),
        (
            "named.csv",
            rows(&first, ",", &seconds),
            r#", "columns": ["t", "x", "y", "z", "qw", "qx", "qy", "qz"]"#,
            true,
        ),
        (
            "over.csv",
            format!("t,x,y,z,rx,ry,rz\n{vectors}"),
            r#", "columns": ["t", "x", "y", "z", "rotvec_x", "rotvec_y", "rotvec_z"]"#,
            true,
        ),
    ] {
        let folder = Folder::with(&[(name, &table), ("m.json", &motion(name, more))]);
        let report = folder.json("report m.json --json");
        let motion = &report["objects"]["m"];
        let expected = if timed { duration } else { (poses.len() - 1) as f64 };
        assert!((motion["duration"].as_f64().unwrap() - expected).abs() < 1e-9, "{name}: {motion}");
        lengths.push((name, motion["length"].as_f64().or(motion["way"].as_f64()).unwrap_or_default()));
    }
    // All are the same poses, to the six figures that they are written with.
    assert!(
        lengths[0].1 > 1.0 && lengths.iter().all(|(_, length)| (length - lengths[0].1).abs() < 1e-5),
        "{lengths:?}"
    );
    // What may be in one order or the other is refused with both.
    let folder = Folder::with(&[("p.csv", &rows(&first, ",", &seconds)), ("m.json", &motion("p.csv", ""))]);
    let error = folder.fails(1, "report m.json");
    assert!(error.contains(r#"`["t", "x", "y", "z", "qw", "qx", "qy", "qz"]`"#), "{error}");
    let folder = Folder::with(&[("p.csv", &format!("t,x,y,z,rx,ry,rz\n{vectors}")), ("m.json", &motion("p.csv", ""))]);
    assert!(folder.fails(1, "report m.json").contains("rotvec_x"));
}

/// What a refusal proposes for the columns of poses, typed, gives the same motion as the table with known names: no rotation is lost on the way.
#[test]
fn what_is_proposed_for_poses_keeps_their_rotations() {
    let euroc = case("poses_euroc.csv");
    let poses: Vec<Vec<f64>> =
        euroc.lines().skip(1).map(|line| line.split(',').skip(1).map(|v| v.parse().unwrap()).collect()).collect();
    // The first pose is not turned, as robots and phones begin.
    let conjugate = [poses[0][3], -poses[0][4], -poses[0][5], -poses[0][6]];
    let turned = |q: &[f64]| {
        let [a, b, c, d] = conjugate;
        [
            a * q[0] - b * q[1] - c * q[2] - d * q[3],
            a * q[1] + b * q[0] + c * q[3] - d * q[2],
            a * q[2] - b * q[3] + c * q[0] + d * q[1],
            a * q[3] + b * q[2] - c * q[1] + d * q[0],
        ]
    };
    let table = |header: &str, separator: &str, order: [usize; 4]| -> String {
        let row = |(i, pose): (usize, &Vec<f64>)| {
            let q = turned(&pose[3..]);
            let numbers = [0.5 * i as f64, pose[0], pose[1], pose[2]].into_iter().chain(order.map(|k| q[k]));
            numbers.map(|v| format!("{v:.9}")).collect::<Vec<_>>().join(separator) + "\n"
        };
        let header = if header.is_empty() { String::new() } else { format!("{header}\n") };
        header + &poses.iter().enumerate().map(row).collect::<String>()
    };
    let motion = |columns: &str| {
        let columns = if columns.is_empty() { String::new() } else { format!(", {columns}") };
        format!(
            r#"{{"cyclide": 1, "units": "m", "objects": {{"m": {{"type": "motion", "kind": "linear", "poses": {{"csv": "p.txt"{columns}}}}}}}}}"#
        )
    };
    let (first, last) = ([0, 1, 2, 3], [1, 2, 3, 0]);
    let plain = Folder::with(&[("p.txt", &table("t,x,y,z,qw,qx,qy,qz", ",", first)), ("m.json", &motion(""))]);
    let expected = plain.json("report m.json --json")["objects"]["m"]["length"].clone();
    let angles = |folder: &Folder| folder.ok("sample m.json --object m --count 9");
    let expected_samples = angles(&plain);
    for (header, separator, order) in [
        ("t,x,y,z,q1,q2,q3,q4", ",", first),
        ("t,x,y,z,q[0],q[1],q[2],q[3]", ",", first),
        ("t,x,y,z,quat_0,quat_1,quat_2,quat_3", ",", last),
        ("t,x,y,z,x.1,y.1,z.1,w", ",", last),
    ] {
        let text = table(header, separator, order);
        let folder = Folder::with(&[("p.txt", &text), ("m.json", &motion(""))]);
        let error = folder.fails(1, "report m.json");
        let columns = error.split_once("`\"columns\": ").and_then(|(_, rest)| rest.split_once('`')).unwrap().0;
        let folder = Folder::with(&[("p.txt", &text), ("m.json", &motion(&format!("\"columns\": {columns}")))]);
        assert_eq!(folder.json("report m.json --json")["objects"]["m"]["length"], expected, "{header}");
        assert_eq!(angles(&folder), expected_samples, "{header}");
    }
    // Eight numbers without names, whose fifth is 1 in the first line: w may be first, and that is refused.
    for (order, code) in [(first, 1), (last, 0)] {
        let folder = Folder::with(&[("p.txt", &table("", " ", order)), ("m.json", &motion(""))]);
        let run = folder.run("report m.json");
        assert_eq!(run.code, code, "{}", run.stderr);
        assert!(code == 0 || run.stderr.contains(r#"["t", "x", "y", "z", "qw", "qx", "qy", "qz"]"#), "{}", run.stderr);
    }
    // Leaving the rotations out is allowed, with a warning.
    let aside = r#""columns": ["t", "x", "y", "z", "-", "-", "-", "-"]"#;
    let folder = Folder::with(&[("p.txt", &table("", " ", last)), ("m.json", &motion(aside))]);
    assert!(folder.run("report m.json").stderr.contains("[taken-as-zero]"));
    // Nor are times of another unit taken for seconds in silence.
    let uptime: String = poses
        .iter()
        .enumerate()
        .map(|(i, p)| format!("{},{},{},{}\n", 5_000_000 + 250_000 * i, p[0], p[1], p[2]))
        .collect();
    let folder = Folder::with(&[("p.txt", &format!("timestamp,x,y,z\n{uptime}")), ("m.json", &motion(""))]);
    assert!(folder.run("report m.json").stderr.contains("taken as seconds, 250000 apart"));
}

/// Files of instruments and drawings are called by their names, and arcs are not taken for their chords.
#[test]
fn what_points_alone_do_not_say_is_refused() {
    let gsi = "*110001+0000000000000001 81..40+0000003456000000 82..40+0000005432000000\n";
    for (name, text, message) in [
        ("p.gsi", gsi, "Leica GSI"),
        ("p.csv", "x,y,bulge\n0,0,0\n100,0,0.41421356\n120,20,0\n", "`--columns 1,2`"),
        ("p.txt", "5432000 456000 412\n5432010 456020 413\n5432020 456030 413\n", "`--columns 2,1,3`"),
    ] {
        let folder = Folder::with(&[(name, text)]);
        let error = folder.fails(1, &format!("curve {name} --units m -o c.step"));
        assert!(error.contains(message), "{error}");
    }
}

/// Tables as instruments, text editors and spreadsheets leave them: what they add is no point.
#[test]
fn what_is_drawn_around_a_table_is_passed_over() {
    let rows = "1;10.5;20.5;3.5\n2;11.5;21.25;3.75\n3;13.5;20.5;4.5\n";
    let expected = [[10.5, 20.5, 3.5], [11.5, 21.25, 3.75], [13.5, 20.5, 4.5]];
    let lines = |table: &str, separator: &str| table.replace(';', separator);
    let piped = |table: &str| table.lines().map(|row| format!("| {} |\n", row.replace(';', " | "))).collect::<String>();
    for text in [
        format!("Nr;Ost;Nord;H\n---;---;---;---\n{rows}"),
        format!("Nr   Ost   Nord   H\n--------------------\n{}", lines(rows, "  ")),
        format!("==========\nNr;Ost;Nord;H\n==========\n{rows}"),
        format!("{}|----|---|---|---|\n{}", piped("Nr;Ost;Nord;H\n"), piped(rows)),
        // Ctrl-Z ends files of DOS.
        format!("Nr;Ost;Nord;H\n{rows}\u{1a}"),
        // Names that tabs align, over fields that they do not.
        format!("Nr\tOst\t\tNord\t\tH\n{}", lines(rows, "\t")),
        format!("Nr\tOst\t\tNord\t\tH\n\t[m]\t\t[m]\t\t[m]\n{}", lines(rows, "\t")),
        "Nr;;Ost;Nord;H\n1;;10.5;20.5;3.5\n2;;11.5;21.25;3.75\n3;;13.5;20.5;4.5\n".to_owned(),
    ] {
        let table =
            read_points("t.csv", text.as_bytes(), &PointColumns::default()).unwrap_or_else(|e| panic!("{e}\n{text}"));
        assert_eq!(points_of(&table), expected, "{text}");
    }
}

/// A refusal says what to do, and where.
#[test]
fn what_is_no_table_of_points_is_refused_with_a_remedy() {
    for (text, message) in [
        ("Punkt;Ost;Nord\n#100;10.5;20.5\n#101;11.5;21.5\n", "2:1: the file has no points; this line is a remark"),
        ("\"x;y\"\n\"1,5;2,5\"\n", "2:1: the file has no points; this line is in quotes as a whole"),
        ("x;y\n1.5 m;2.5 m\n", "2:1: the file has no points; no line has two numbers alone"),
        ("Nr;x;y;d\n1;1.5;2.5;3\nSumme;;;3\n", "`Summe` is not the name of a point: remove this line"),
        ("Nr;x;y\n1;1.5;2.5\nNr;x;y\n2;3;4\n", "3:1: the names of the columns are repeated here: remove"),
        ("Nr;x;y\n1;1.5;2.5\nPrinted on Monday\n", "the line has 1 field; remove it if it is no point"),
        ("Nr Ost Nord\nGP 1 1.5 2.5\n", "put names of several words in quotes"),
        ("158,621,80,014\n152,853,91,250\n", "decimal commas and separate the columns too"),
        ("Nr\tOst\t\tNord\t\tH\tCode\n1\t2.5\t3.5\t4.5\n", "4 columns"),
    ] {
        let refused =
            read_points("t.csv", text.as_bytes(), &PointColumns::default()).map(|t| points_of(&t)).unwrap_err();
        assert!(refused.to_string().contains(message), "{refused}");
    }
    // Commands that are offered keep the heights.
    for text in [
        "1000;456038.6;5432000.5;412.4;100\n1001;456032.8;5432011.5;413.1;101\n1002;456021.6;5432017.5;413.7;102\n",
        "foo;bar;baz;Höhe\n456038.6;5432000.5;7.5;412.4\n456032.8;5432011.5;7.5;413.1\n",
    ] {
        let refused =
            read_points("t.csv", text.as_bytes(), &PointColumns::default()).map(|t| points_of(&t)).unwrap_err();
        let columns = PointColumns { coordinates: command_in(&refused.message), ..PointColumns::default() };
        let table = read_points("t.csv", text.as_bytes(), &columns).unwrap();
        assert!((points_of(&table)[0][2] - 412.4).abs() < 1e-9, "{refused}");
    }
    // The Hochwert of a second system is no height.
    let two = "Nr;E UTM;N UTM;R GK;H GK\n1;456038.6;5432000.5;3456039.1;5432800.2\n2;456032.8;5432011.5;3456033.3;5432811.2\n";
    let table = read_points("t.csv", two.as_bytes(), &PointColumns::default()).unwrap();
    assert_eq!(format!("{:?}", points_of(&table)[0]), "[456038.6, 5432000.5, 0.0]");
    // Longitudes and latitudes that are called x and y are said.
    let degrees = "X,Y\n13.4050123,52.5200123\n13.4060456,52.5201456\n13.4070789,52.5209789\n";
    let table = read_points("t.csv", degrees.as_bytes(), &PointColumns::default()).unwrap();
    assert!(table.remarks.iter().any(|remark| remark.message.contains("in degrees")), "{:?}", table.remarks);
}

/// Numbers that look random and are the same each time.
struct Random(u64);

impl Random {
    fn below(&mut self, count: usize) -> usize {
        self.0 = self.0.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
        ((self.0 >> 33) % count as u64) as usize
    }

    fn chance(&mut self, of: usize) -> bool {
        self.below(of) == 0
    }

    fn one<T: Copy>(&mut self, of: &[T]) -> T {
        of[self.below(of.len())]
    }
}

/// Names of columns: of the number, then of the coordinates with the axis that each of them is.
type Names = (&'static [&'static str], &'static [(&'static str, usize)]);

const LANGUAGES: [Names; 20] = [
    (
        &["No.", "Point", "Point ID", "PtID", "OBJECTID", "FID", "Vertex", "seq", "idx", "Pt #"],
        &[("Easting", 0), ("Northing", 1)],
    ),
    (&["No", "Point No", "ID", "Name"], &[("Northing", 1), ("Easting", 0), ("Elevation", 2)]),
    (&["station", "chainage", "km", "Num."], &[("x", 0), ("y", 1)]),
    (&["#", "Index", "fid"], &[("POINT_X", 0), ("POINT_Y", 1), ("POINT_Z", 2)]),
    (&["Pkt", "Punktnummer", "Nr.", "Lfd. Nr.", "Punkt"], &[("Rechtswert", 0), ("Hochwert", 1)]),
    (&["Pkt.-Nr.", "Punktnr", "Kennung"], &[("Nord", 1), ("Ost", 0)]),
    (&["Punkt", "Station"], &[("Hochwert", 1), ("Rechtswert", 0), ("Höhe", 2)]),
    (&["N°", "Numéro", "Matricule", "Nom"], &[("Abscisse", 0), ("Ordonnée", 1)]),
    (&["N° point", "PK"], &[("Est", 0), ("Nord", 1), ("Altitude", 2)]),
    (&["Matricule"], &[("Nord", 1), ("Est", 0)]),
    (&["Punto", "Num. punto", "Numero"], &[("Est", 0), ("Nord", 1), ("Quota", 2)]),
    (&["Punto", "Nº", "Número", "Progresiva"], &[("Este", 0), ("Norte", 1), ("Cota", 2)]),
    (&["Id. punto"], &[("Norte", 1), ("Este", 0)]),
    (&["ID"], &[("E", 0), ("N", 1), ("H", 2)]),
    (&["Point"], &[("X (Easting)", 0), ("Y (Northing)", 1), ("RL", 2)]),
    (&["PktNr"], &[("East", 0), ("North", 1), ("Geländehöhe", 2)]),
    (&["Nr."], &[("MTM_N", 1), ("MTM_E", 0), ("Rzędna", 2)]),
    (&["Ponto"], &[("M", 0), ("P", 1), ("Cota", 2)]),
    // Words that nobody knows.
    (&["Merkmal", "w1"], &[("foo", 0), ("bar", 1)]),
    (&[], &[]),
];

/// A table in a random dialect, with its points.
fn table(random: &mut Random) -> (Vec<u8>, Vec<[f64; 3]>, String) {
    let (labels, axes) = random.one(&LANGUAGES);
    let named = !axes.is_empty();
    let axes = if named { axes } else { &[("", 0), ("", 1), ("", 2)][..2 + random.below(2)] };
    let separator = random.one(&[",", ";", "\t", " "]);
    let quoted = separator == "," && random.chance(2);
    let comma = separator != "," && random.chance(2) || quoted && random.chance(2);
    let plain_names = separator != " " || axes.iter().all(|(name, _)| !name.contains(' '));
    let grouped = separator != " " && random.chance(3);
    let mark = match (comma, separator == "," && !quoted) {
        _ if !grouped => "",
        (_, true) => random.one(&["'", " "]),
        (true, _) => random.one(&[".", " ", "\u{a0}", "'"]),
        (false, _) => random.one(&[",", "'", "\u{202f}"]),
    };
    let digits = if quoted { 2 } else { 2 + random.below(2) };
    let size = random.one(&[40, 3_000, 900_000]);
    let count = 4 + random.below(20);
    let points: Vec<[i64; 3]> = (0..count)
        .map(|_| {
            [0; 3].map(|_: i64| {
                random.below(size * 10_usize.pow(digits as u32)) as i64 - if random.chance(3) { size as i64 } else { 0 }
            })
        })
        .collect();
    // Thousands are certain where a number has them, with a fraction.
    let write = |value: i64| {
        let (whole, fraction) = (value.abs() / 10_i64.pow(digits as u32), value.abs() % 10_i64.pow(digits as u32));
        let figures = whole.to_string();
        let mut text = String::new();
        for (k, c) in figures.chars().enumerate() {
            if k > 0 && (figures.len() - k) % 3 == 0 {
                text.push_str(mark);
            }
            text.push(c);
        }
        let sign = if value < 0 { "-" } else { "" };
        format!("{sign}{text}{}{fraction:0digits$}", if comma { "," } else { "." })
    };
    let cell = |text: String| if quoted { format!("\"{text}\"") } else { text };
    let label = (!labels.is_empty() || !named && random.chance(2))
        .then(|| if labels.is_empty() { "" } else { random.one(labels) });
    let label = label.filter(|label| separator != " " || !label.contains(' ')).filter(|_| named || plain_names);
    let numbering = random.below(3);
    let code = named && separator != " " && random.chance(3);
    let mut lines: Vec<String> = Vec::new();
    if separator != " " && random.chance(5) {
        lines.push(format!("sep={separator}"));
    }
    let header_fits = named && plain_names;
    if header_fits && random.chance(4) {
        // Between blanks a title with a number may be a point, and is refused as one that has no numbers.
        let titles = &["Aufmaß Werkhof Süd", "Export", "Levé du 12 mars", "Project 17"];
        lines.push(random.one(if separator == " " { &titles[..2] } else { &titles[..] }).to_owned());
        if separator != " " && random.chance(2) {
            lines.push(separator.repeat(axes.len()));
        }
    }
    let units = header_fits && separator != " " && random.chance(4);
    if header_fits {
        let names = label.iter().copied().chain(axes.iter().map(|(name, _)| *name)).chain(code.then_some("Code"));
        lines.push(names.map(|name| cell(name.to_owned())).collect::<Vec<_>>().join(separator));
    }
    if units {
        let form = random.one(&["[m]", "(m)", "m"]);
        let cells = label.iter().map(|_| "").chain(axes.iter().map(|_| form)).chain(code.then_some(""));
        lines.push(cells.collect::<Vec<_>>().join(separator));
    }
    for (i, point) in points.iter().enumerate() {
        let number = match numbering {
            0 => (i + 1).to_string(),
            1 => (10 * (i + 1)).to_string(),
            _ => format!("B{}", i + 7),
        };
        let label = label.map(|_| number);
        let numbers = axes.iter().map(|(_, axis)| write(point[*axis]));
        let cells = label.into_iter().chain(numbers).map(cell).chain(code.then(|| "KS".to_owned()));
        lines.push(cells.collect::<Vec<_>>().join(separator));
    }
    if separator == ";" && random.chance(3) {
        lines.push(";".repeat(axes.len()));
    }
    let text = lines.join(random.one(&["\n", "\r\n"])) + "\n";
    let latin = || text.chars().map(|c| u8::try_from(u32::from(c)).ok()).collect::<Option<Vec<u8>>>();
    let bytes = match random.below(5) {
        0 => [&b"\xef\xbb\xbf"[..], text.as_bytes()].concat(),
        1 => latin().unwrap_or_else(|| text.clone().into_bytes()),
        2 => [0xFF, 0xFE].into_iter().chain(text.encode_utf16().flat_map(u16::to_le_bytes)).collect(),
        _ => text.clone().into_bytes(),
    };
    let scale = 10_f64.powi(digits as i32);
    let has = |axis: usize| axes.iter().any(|(_, own)| *own == axis);
    let expected = points.iter().map(|p| [0, 1, 2].map(|axis| if has(axis) { p[axis] as f64 / scale } else { 0.0 }));
    (bytes, expected.collect(), text.clone())
}

fn points_of(table: &PointTable) -> Vec<[f64; 3]> {
    table.contours.iter().flat_map(|list| &list.points).map(|p| p.to_array()).collect()
}

/// The columns that a message says to choose first.
fn command_in(message: &str) -> Option<Vec<String>> {
    let (_, rest) = message.split_once("--columns ")?;
    let columns = rest.split(['`', ' ', ')']).next()?;
    Some(columns.split(',').map(str::to_owned).collect())
}

#[test]
fn random_tables_give_their_points_or_the_command_that_does() {
    let mut random = Random(37);
    let (mut read_at_once, mut by_command) = (0, 0);
    for _ in 0..2000 {
        let (bytes, expected, text) = table(&mut random);
        let found = match read_points("t.csv", &bytes, &PointColumns::default()) {
            Ok(found) => {
                read_at_once += 1;
                found
            }
            Err(refused) => {
                by_command += 1;
                let columns = command_in(&refused.message).unwrap_or_else(|| panic!("{refused}\n{text}"));
                let columns = PointColumns { coordinates: Some(columns), ..PointColumns::default() };
                read_points("t.csv", &bytes, &columns).unwrap_or_else(|again| panic!("{refused}\n{again}\n{text}"))
            }
        };
        assert_eq!(points_of(&found), expected, "{:?}\n{text}", found.notes);
    }
    assert!(read_at_once > 1500 && by_command > 50, "{read_at_once} at once, {by_command} by the command");
}
