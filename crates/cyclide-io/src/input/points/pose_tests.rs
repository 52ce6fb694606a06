//! Tables of poses under many names: what is read is right, and what is proposed is read when it is typed.

use std::f64::consts::PI;

use cyclide::{Vec3, motion::Pose};

use super::poses::{PoseTable, read_poses};

const TIMES: [f64; 3] = [0.0, 0.5, 1.25];
const PLACES: [[f64; 3]; 3] = [[92.5, 200.0, 110.0], [188.25, 223.5, 106.125], [297.75, 247.25, 89.5]];
/// Roll, pitch and yaw in degrees.
const TURNS: [[f64; 3]; 3] = [[5.0, 15.0, -20.0], [14.5, 13.0, -15.0], [24.0, 4.75, -10.0]];

fn pose(row: usize) -> Pose {
    let [x, y, z] = PLACES[row];
    Pose::from_roll_pitch_yaw(Vec3::new(x, y, z), TURNS[row].map(|angle| angle * PI / 180.0)).unwrap()
}

/// What a line has of a kind of number: `t`, `x`, `roll` (radians), `roll_deg`, `qw`, `m00` (from 0), `sec`, `nanosec`, `iso`, `clock` (of the day), `one`.
fn number(row: usize, kind: &str) -> String {
    let axis = |names: [&str; 3]| names.iter().position(|name| *name == kind);
    let matrix = pose(row).to_matrix();
    let exact = |value: f64| format!("{value}");
    if let Some(axis) = axis(["x", "y", "z"]) {
        return exact(PLACES[row][axis]);
    } else if let Some(axis) = axis(["roll_deg", "pitch_deg", "yaw_deg"]) {
        return exact(TURNS[row][axis]);
    } else if let Some(axis) = axis(["roll", "pitch", "yaw"]) {
        return exact(TURNS[row][axis] * PI / 180.0);
    } else if let Some(k) = ["qw", "qx", "qy", "qz"].iter().position(|name| *name == kind) {
        let q = pose(row).rotation();
        return exact([q.w, q.x, q.y, q.z][k]);
    }
    let seconds = ["00.000", "00.500", "01.250"][row];
    match kind {
        "t" => exact(TIMES[row]),
        "ms" => exact(1e3 * TIMES[row]),
        "count" => row.to_string(),
        "sec" => ["1700000000", "1700000000", "1700000001"][row].to_owned(),
        "nanosec" => ["0", "500000000", "250000000"][row].to_owned(),
        "iso" => format!("2026-11-28T10:00:{seconds}Z"),
        "clock" => format!("10:00:{seconds}"),
        "one" => "1".to_owned(),
        entry => {
            let digit = |k: usize| usize::from(entry.as_bytes()[k] - b'0');
            exact(matrix[digit(1)][digit(2)])
        }
    }
}

/// A table whose columns are `name=kind`, or a name that is its kind.
fn table(columns: &str) -> String {
    let columns: Vec<(&str, &str)> = columns.split(',').map(|one| one.split_once('=').unwrap_or((one, one))).collect();
    let line = |of: &dyn Fn(&(&str, &str)) -> String| columns.iter().map(of).collect::<Vec<_>>().join(",") + "\n";
    let rows: String = (0..3).map(|row| line(&|(_, kind)| number(row, kind))).collect();
    line(&|(name, _)| (*name).to_owned()) + &rows
}

fn read(text: &str, columns: Option<&[String]>) -> Result<PoseTable, String> {
    read_poses("p.csv", text.as_bytes(), columns, true, 2e-3).map_err(|refusal| refusal.message)
}

/// The words between the brackets of a proposal.
fn proposed(message: &str) -> Option<Vec<String>> {
    let list = message.split_once("`\"columns\": [")?.1.split_once("]`")?.0;
    Some(list.split(", ").map(|word| word.trim_matches('"').to_owned()).collect())
}

/// Asserts the poses, and their times where they are not left out.
fn assert_right(found: &PoseTable, columns: &str) {
    for (row, own) in found.poses.iter().enumerate() {
        let first = found.poses[0].time;
        let time = own.time.zip(first).map(|(time, first)| time - first);
        assert!(time.is_some_and(|time| (time - TIMES[row]).abs() < 1e-12), "{columns}: {time:?}");
        // Twelve figures and more are in the tables.
        let off = (own.pose.translation() - pose(row).translation()).length();
        assert!(off < 1e-11 && own.pose.angle_to(pose(row)) < 1e-7, "{columns}: {off}");
    }
}

const TURNED: &str = "x,y,z,qw,qx,qy,qz";
const ANGLES: &str = "roll_deg,pitch_deg,yaw_deg";

#[test]
fn clocks_are_read_in_many_words() {
    for name in [
        "seconds",
        "elapsed",
        "elapsed_s",
        "elapsed [s]",
        "ts",
        "tstamp",
        "time_since_start",
        "sim_time",
        "wall_time",
        "epoch",
        "clock",
        "Zeitstempel",
        "Uhrzeit",
        "Sekunden",
        "temps",
        "secondes",
        "tempo",
        "secondi",
        "tiempo",
        "segundos",
        "t_rel",
        "gps_time",
        "unix_time [s]",
        "ros_time",
    ] {
        let columns = format!("{name}=t,{TURNED}");
        let found = read(&table(&columns), None).unwrap_or_else(|message| panic!("{columns}: {message}"));
        assert_right(&found, &columns);
    }
    for columns in [
        "millis=ms",
        "Zeit [ms]=ms",
        "header.stamp.nanosec=nanosec,header.stamp.sec=sec",
        "header.stamp.sec=sec,header.stamp.nanosec=nanosec",
        "nsecs=nanosec,secs=sec",
        "time=iso",
        "timestamp=iso",
        "Uhrzeit=clock",
        "time [s]=clock",
    ] {
        let columns = format!("{columns},{TURNED}");
        let found = read(&table(&columns), None).unwrap_or_else(|message| panic!("{columns}: {message}"));
        assert_right(&found, &columns);
    }
}

#[test]
fn places_are_read_in_many_words() {
    for name in [
        "altitude",
        "height",
        "alt",
        "elevation",
        "H\u{f6}he",
        "RL",
        "z_up",
        "up",
        "altitude_m",
        "Alt [m]",
        "hauteur",
        "quota",
        "altura",
    ] {
        let columns = format!("t,x,y,{name}=z,{ANGLES}");
        let found = read(&table(&columns), None).unwrap_or_else(|message| panic!("{columns}: {message}"));
        assert_right(&found, &columns);
        assert!(found.notes.iter().any(|note| note.contains("is z")) && found.taken_as_zero.is_none(), "{columns}");
    }
    let zero = "m00,m01,m02,m03,m10,m11,m12,m13,m20,m21,m22,m23";
    let names: Vec<String> =
        zero.split(',').map(|name| format!("T[{}][{}]={name}", &name[1..2], &name[2..3])).collect();
    let ones: Vec<String> = zero
        .split(',')
        .filter(|name| !name.ends_with('3'))
        .map(|name| {
            let number: usize = name[1..].parse().unwrap();
            format!("r{}={name}", number + 11)
        })
        .collect();
    for columns in [
        zero.to_owned(),
        names.join(","),
        format!("tx=x,ty=y,tz=z,{}", ones.join(",")),
        format!("position[0]=x,position[1]=y,position[2]=z,{ANGLES}"),
        format!("pose.position[0]=x,pose.position[1]=y,pose.position[2]=z,{ANGLES}"),
        format!("pos_1=x,pos_2=y,pos_3=z,{ANGLES}"),
        format!("easting=x,northing=y,height=z,{ANGLES}"),
        format!("Hochwert=y,Rechtswert=x,H\u{f6}he=z,{ANGLES}"),
    ] {
        let columns = format!("t,{columns}");
        let found = read(&table(&columns), None).unwrap_or_else(|message| panic!("{columns}: {message}"));
        assert_right(&found, &columns);
    }
}

/// Zero-based and one-based names are never mixed, and missing entries have the names of their table.
#[test]
fn entries_count_from_one_number() {
    let message = read(&table("m00,m01,m02,m03,m10,m11,m12,m13,m20,m21,m22,m14=m23"), None).err().unwrap();
    assert!(message.contains("`m14` is numbered from 1, and other entries from 0"), "{message}");
    let message = read(&table("m00,m01,m02,m03,m10,m11,m12,m13,m20,m21,m22"), None).err().unwrap();
    assert!(message.contains("no column is named `m23`"), "{message}");
}

#[test]
fn what_is_refused_names_its_remedy() {
    for (columns, words) in [
        // Unknown names of columns that rise are for the person to decide, and no one else is asked for.
        (
            "s=t,x,y,z,qw,qx,qy,qz".to_owned(),
            r#"["?", "x", "y", "z", "qw", "qx", "qy", "qz"]`, with the right word for each `?` (`t` for the time)"#,
        ),
        ("when=t,x,y,z,qw,qx,qy,qz".to_owned(), r#"["?", "x""#),
        ("when=iso,x,y,z,qw,qx,qy,qz".to_owned(), r#"["?", "x""#),
        ("elapsed [h]=t,x,y,z,qw,qx,qy,qz".to_owned(), r#"["?", "x""#),
        ("sample_k=count,x,y,z,qw,qx,qy,qz".to_owned(), r#"["-", "x""#),
        ("t,when=t,x,y,z,qw,qx,qy,qz".to_owned(), r#"["t", "-", "x""#),
        (format!("t,x,y,Deckenh\u{f6}he=z,{ANGLES}"), r#"["t", "x", "y", "?", "#),
        (format!("t,x,y,alt=z,height=z,{ANGLES}"), r#"["t", "x", "y", "?", "?", "#),
        (format!("t,x,y,h=z,{ANGLES}"), r#"["t", "x", "y", "?", "#),
        (format!("t,x,y,down=z,{ANGLES}"), r#"["t", "x", "y", "?", "#),
        (format!("t,E=x,N=y,H=z,{ANGLES}"), r#"["t", "x", "y", "z", "roll_deg", "pitch_deg", "yaw_deg"]"#),
        (format!("t,E [m]=x,N [m]=y,H [m]=z,{ANGLES}"), r#"["t", "x_m", "y_m", "z_m", "#),
        (format!("timestamp=t,lat=x,lon=y,alt=z,{ANGLES}"), "lon, lat are geographic angles: project them"),
        (format!("when=t,foo=x,bar=y,z,{ANGLES}"), "\"?\""),
        (format!("t,foo=one,y,z,{ANGLES}"), "not a table of poses: no column is named `x`"),
        (
            "t,x,y,z,quaternion[0]=qw,quaternion[1]=qx,quaternion[2]=qy,quaternion[3]=qz".to_owned(),
            r#""z", "qw", "qx", "qy", "qz"]"#,
        ),
        (
            "t,x,y,z,pose.orientation[0]=qx,pose.orientation[1]=qy,pose.orientation[2]=qz,pose.orientation[3]=qw"
                .to_owned(),
            r#""z", "qx", "qy", "qz", "qw"]"#,
        ),
    ] {
        let message = read(&table(&columns), None).err().unwrap_or_else(|| panic!("{columns}"));
        assert!(message.contains(words), "{columns}: {message}");
    }
    let message = read("time,x,y\n10:61:00,1,2\n", None).err().unwrap();
    assert!(message.contains("is not a time: write seconds"), "{message}");
    let message = read("time,x,y\n23:59:59,1,2\n00:00:01,1,3\n", None).err().unwrap();
    assert!(message.contains("write them with their dates"), "{message}");
}

/// Every proposal is read when it is typed, unless it leaves something open; and then all that is known is right.
#[test]
fn every_proposal_is_read_when_it_is_typed() {
    let times = [
        "t",
        "s=t",
        "when=t",
        "elapsed [h]=t",
        "index=count,time=t",
        "k=count",
        "time=t,elapsed=t",
        "nanosec=nanosec,sec=sec",
        "stempel=iso",
        "x_time=t",
    ];
    let long = "a_very_long_path_of_a_message_that_nobody_can_read_to_its_end.pose.position";
    let places = [
        "x,y,z".to_owned(),
        "x,y,alt=z".to_owned(),
        "x,y,alt=z,height=z".to_owned(),
        "x,y,Deckenh\u{f6}he=z".to_owned(),
        "E=x,N=y,H=z".to_owned(),
        "N=y,E=x,D=z".to_owned(),
        "easting=x,northing=y,up=z".to_owned(),
        "lat=x,lon=y,alt=z".to_owned(),
        "position[0]=x,position[1]=y,position[2]=z".to_owned(),
        "p1=x,p2=y,p3=z".to_owned(),
        "foo=x,bar=y".to_owned(),
        format!("{long}.x=x,{long}.y=y,{long}.z=z"),
    ];
    let turns = [
        "qw,qx,qy,qz",
        "roll,pitch,yaw",
        "theta_deg=yaw_deg",
        "heading=yaw",
        "force=one",
        "W=roll_deg,P=pitch_deg,R=yaw_deg,grip=one",
        "rx=roll,ry=pitch,rz=yaw",
        "q1=qw,q2=qx,q3=qy,q4=qz",
        "m00,m01,m02,m10,m11,m12,m20,m21,m22",
        "m00,m01,m02,m10,m11,m12,m20,m21,m22=m22,m13=m03",
    ];
    let (mut typed, mut open) = (0, 0);
    for (time, place) in times.iter().flat_map(|time| places.iter().map(move |place| (time, place))) {
        for turn in turns {
            let columns = format!("{time},{place},{turn}");
            let text = table(&columns);
            let Some(words) = read(&text, None).err().and_then(|message| proposed(&message)) else { continue };
            if words.contains(&"?".to_owned()) {
                open += 1;
                continue;
            }
            typed += 1;
            if let Err(message) = read(&text, Some(&words)) {
                panic!("{columns}: {words:?}: {message}");
            }
        }
    }
    assert!(typed >= 60 && open >= 60, "{typed} of {open}");
}

/// Beside places of other names a bare `x, y, z, w` can be the quaternion only.
#[test]
fn a_bare_quaternion_is_read_beside_named_places() {
    for columns in [
        "t,px=x,py=y,pz=z,x=qx,y=qy,z=qz,w=qw",
        "t,pos_x=x,pos_y=y,pos_z=z,w=qw,x=qx,y=qy,z=qz",
        "t,x=qx,y=qy,z=qz,w=qw,tx=x,ty=y,tz=z",
    ] {
        let found = read(&table(columns), None).unwrap_or_else(|message| panic!("{columns}: {message}"));
        assert_right(&found, columns);
    }
    for columns in ["t,px=x,py=y,x=qx,y=qy,z=qz,w=qw", "t,px=x,py=y,pz=z,x=qx,y=qy,w=qw", "t,x,y,z,w=qw,qw,qx,qy,qz"] {
        assert!(read(&table(columns), None).is_err(), "{columns}");
    }
}
