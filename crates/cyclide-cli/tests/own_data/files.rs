//! Files and folders under pressure: limits of the process, signals, documents that nobody vouches for.

use std::process::{Command, Stdio};

use crate::common::{Folder, Run};

const CIRCLE: &str = r#"{"cyclide": 1, "objects": {"c": {"type": "circle", "center": [0, 0], "radius": 1}}}"#;

/// A document of circles.
fn circles(count: usize, radius: f64) -> String {
    let circle = |i| format!(r#""c{i}": {{"type": "circle", "center": [{i}, 0], "radius": {radius}}}"#);
    let all: Vec<String> = (0..count).map(circle).collect();
    format!(r#"{{"cyclide": 1, "objects": {{{}}}}}"#, all.join(","))
}

/// A document of an object that reads a file.
fn reading(field: &str) -> String {
    format!(r#"{{"cyclide": 1, "objects": {{"c": {{"type": "arc-spline", "points": {field}}}}}}}"#)
}

/// Everything below a folder, temporary folders and files too.
fn content(folder: &std::path::Path) -> std::collections::BTreeMap<String, Vec<u8>> {
    let mut all = std::collections::BTreeMap::new();
    for entry in std::fs::read_dir(folder).unwrap() {
        let path = entry.unwrap().path();
        let name = path.file_name().unwrap().to_string_lossy().into_owned();
        if path.is_dir() {
            all.extend(content(&path).into_iter().map(|(inner, bytes)| (format!("{name}/{inner}"), bytes)));
        } else {
            all.insert(name, std::fs::read(&path).unwrap());
        }
    }
    all
}

fn names(folder: &Folder) -> Vec<String> {
    let mut names: Vec<String> = std::fs::read_dir(folder.path("."))
        .unwrap()
        .map(|entry| entry.unwrap().file_name().to_string_lossy().into_owned())
        .collect();
    names.sort();
    names
}

#[test]
fn a_name_with_a_separator_at_its_end_is_refused_before_anything_is_written() {
    let folder = Folder::with(&[("c.json", CIRCLE), ("p.csv", "x,y\n0,0\n1,0\n1,1\n")]);
    for command in [
        "build c.json -o a.svg -o b.step/",
        "build c.json -o b.step/. -o a.svg",
        "build c.json -o b/ --format step",
        "curve p.csv -o b.step/",
        "sample c.json --count 3 -o b.csv/",
        "compare p.csv -o b.html/",
        "new arc -o b.json/",
    ] {
        let error = folder.fails(2, command);
        assert!(error.contains("is a folder: a file name is required"), "{command}\n{error}");
        assert_eq!(names(&folder), ["c.json", "p.csv"], "{command}");
    }
    // Folders are called so.
    folder.ok("man -o pages/");
    assert!(folder.has("pages/cyclide.1"));
}

#[test]
fn a_document_reads_below_one_folder_only() {
    let folder = Folder::with(&[("secret.csv", "x,y\nthe,password\n")]);
    let points = "x,y\n0,0\n1,0\n1,1\n";
    std::fs::create_dir_all(folder.path("in/sub")).unwrap();
    for name in ["in/p.csv", "in/sub/p.csv"] {
        folder.write(name, points);
    }
    let absolute = folder.path("secret.csv").display().to_string();
    for (file, is_read) in [
        ("p.csv", true),
        ("sub/../p.csv", true),
        ("../in/sub/p.csv", true),
        ("../secret.csv", false),
        (absolute.as_str(), false),
        ("../nothing.csv", false),
        ("/proc/self/environ", false),
        ("/etc/passwd", false),
    ] {
        folder.write("in/m.json", &reading(&format!(r#"{{"csv": "{file}"}}"#)));
        for command in ["report in/m.json", "build in/m.json -o out.svg", "sample in/m.json --count 3"] {
            let run = folder.run(&format!("{command} --read-below in"));
            if is_read {
                assert_eq!((run.code, run.stderr.as_str()), (0, ""), "{file}");
            } else {
                assert_eq!(run.code, 3, "{file}");
                let why = "it is not below the folder in, to which reading is restricted";
                assert!(run.stderr.contains(why) && !run.stderr.contains("password"), "{}", run.stderr);
            }
        }
    }
    // The document itself may be anywhere, and standard input is what the caller gives.
    folder.write("m.json", &reading(r#"{"csv": "in/p.csv"}"#));
    folder.ok("report m.json --read-below in");
    folder.write("m.json", &reading(r#"{"csv": "-"}"#));
    let stdin = std::fs::File::open(folder.path("in/p.csv")).unwrap();
    let run = folder.command().args(["report", "m.json", "--read-below", "in"]).stdin(stdin).output().unwrap();
    assert!(run.status.success());
    assert!(folder.fails(3, "report m.json --read-below nowhere").contains("cannot read nowhere"));
}

#[test]
fn what_a_terminal_acts_on_is_shown_by_its_number() {
    let ply = crate::case("bidi.ply");
    assert!(ply.contains('\u{202e}'));
    let mesh = r#"{"cyclide": 1, "objects": {"m": {"type": "smooth-mesh", "mesh": {"ply": "bidi.ply"}}}}"#;
    let named = r#"{"cyclide": 1, "objects": {"gnp\u202e\u200b": {"type": "circle", "center": [0, 0], "radius": 1}}}"#;
    let table = "x,y\u{9b}31m\n0,0\n1,\u{1b}[2Jz\n";
    let folder = Folder::with(&[("bidi.ply", &ply), ("m.json", mesh), ("n.json", named), ("t.csv", table)]);
    let is_shown = |text: &str| {
        let hidden = |c: char| c.is_control() && c != '\n' || ('\u{200b}'..='\u{202e}').contains(&c);
        assert!(!text.contains(hidden), "{text:?}");
    };
    let runs = [
        (1, vec!["report", "m.json"], r"-5\u{202e}.25731134"),
        (0, vec!["report", "n.json"], r"gnp\u{202e}\u{200b}"),
        (0, vec!["build", "n.json", "-o", "a\u{202e}.svg"], r"a\u{202e}.svg"),
        (2, vec!["sample", "n.json", "--object", "\u{1b}[31mx", "--count", "3"], r"\u{1b}[31mx"),
        (1, vec!["curve", "t.csv", "-o", "a.svg", "--columns", "1,2"], r"\u{1b}[2Jz"),
        (3, vec!["report", "\u{2066}none.json"], r"\u{2066}none.json"),
        (2, vec!["bui\u{202e}ld"], r"bui\u{202e}ld"),
        (2, vec!["build", "n.json", "-o", "a.svg", "--\u{1b}[2J"], "unexpected argument"),
    ];
    for (code, arguments, shown) in runs {
        let run = Run::new(folder.command().args(&arguments).output().unwrap());
        assert_eq!(run.code, code, "{arguments:?}: {}", run.stderr);
        is_shown(&run.stdout);
        is_shown(&run.stderr);
        assert!((run.stdout.clone() + &run.stderr).contains(shown), "{arguments:?}: {}{}", run.stdout, run.stderr);
    }
    // JSON has escapes of its own, and the same value.
    let text = folder.ok("report n.json --json");
    is_shown(&text);
    let report: serde_json::Value = serde_json::from_str(&text).unwrap();
    assert!(report["objects"].get("gnp\u{202e}\u{200b}").is_some());
}

#[test]
fn a_picture_does_not_speak_of_the_tolerance_of_a_fit() {
    let point = |i: u32| {
        let (sin, cos) = (f64::from(i) * std::f64::consts::TAU / 200.0).sin_cos();
        format!("{},{}\n", 1000.0 * cos, 600.0 * sin)
    };
    let points: String = (0..200).map(point).collect();
    let folder = Folder::with(&[("p.csv", &format!("x,y\n{points}"))]);
    for fit in ["--kind arc-fit --tolerance 0.05", "--smooth 0.05"] {
        let report = folder.json(&format!("curve p.csv --closed {fit} -o p.png -o p.dxf --json"));
        let deviation = report["objects"]["p"]["fit"]["deviation"].as_f64().unwrap();
        assert!(deviation <= 0.05, "{deviation}");
        for file in report["files"].as_array().unwrap() {
            let notes = file["notes"].to_string();
            assert!(!notes.contains("is not met"), "{notes}");
        }
    }
}

#[cfg(unix)]
mod unix {
    use super::*;
    use std::io::Read as _;
    use std::os::unix::fs::symlink;
    use std::os::unix::process::ExitStatusExt as _;
    use std::time::{Duration, Instant};

    /// Runs the program from a shell that has set something before: `ulimit -n 64`.
    fn after(folder: &Folder, setting: &str, arguments: &str) -> Run {
        let script = format!("{setting}; exec {} {arguments}", env!("CARGO_BIN_EXE_cyclide"));
        Run::new(Command::new("sh").args(["-c", &script]).current_dir(folder.path(".")).output().unwrap())
    }

    #[test]
    fn many_files_need_few_open_ones() {
        let folder = Folder::with(&[("m.json", &circles(200, 1.0))]);
        std::fs::create_dir(folder.path("out")).unwrap();
        for output in ["p.svg", "out/p.svg"] {
            let run = after(&folder, "ulimit -n 32", &format!("build m.json --per-object -o {output}"));
            assert_eq!(run.code, 0, "{}", run.stderr);
        }
        assert_eq!((std::fs::read_dir(folder.path("out")).unwrap().count(), folder.count()), (200, 202));
    }

    #[test]
    fn queues_of_the_system_and_pipes_are_not_waited_for() {
        let folder = Folder::with(&[]);
        let _ = Command::new("mkfifo").arg(folder.path("pipe")).status();
        symlink("pipe", folder.path("link")).unwrap();
        for file in ["/proc/kmsg", "/proc/self/fd/0", "/dev/zero", "/dev/tty", "pipe", "link", "/proc/self/maps"] {
            folder.write("m.json", &reading(&format!(r#"{{"csv": "{file}"}}"#)));
            for below in ["", " --read-below /"] {
                let run = folder.run(&format!("report m.json{below}"));
                assert!(run.code == 3 && run.stderr.contains("cannot read"), "{file}: {}", run.stderr);
            }
        }
    }

    #[test]
    fn signals_leave_no_temporary_file() {
        let folder = Folder::with(&[("c.json", CIRCLE), ("a.step", "old")]);
        if !Command::new("mkfifo").arg(folder.path("pipe.svg")).status().is_ok_and(|status| status.success()) {
            return;
        }
        let there = ["a.step", "c.json", "pipe.svg"];
        for (signal, number) in [("HUP", 1), ("INT", 2), ("QUIT", 3), ("TERM", 15)] {
            // It waits for a reader of the pipe, with the other file complete under a temporary name.
            let mut command = folder.command();
            command.args(["build", "c.json", "-o", "pipe.svg", "-o", "a.step"]).stdout(Stdio::null());
            let mut child = command.spawn().unwrap();
            let begin = Instant::now();
            while names(&folder) == there && begin.elapsed() < Duration::from_secs(60) {
                std::thread::sleep(Duration::from_millis(5));
            }
            assert_eq!(folder.count(), 4);
            let sent = Command::new("kill").args(["-s", signal, &child.id().to_string()]).status().unwrap();
            assert!(sent.success());
            assert_eq!(child.wait().unwrap().signal(), Some(number), "the caller learns what ended it");
            assert_eq!(names(&folder), there, "{signal}");
            assert_eq!(folder.read("a.step"), b"old");
        }
    }

    #[test]
    fn a_file_beyond_the_limit_of_the_process_is_an_error() {
        let folder = Folder::with(&[("m.json", &circles(100, 1.0)), ("a.step", "old")]);
        for setting in ["ulimit -f 1", "trap '' XFSZ; ulimit -f 1"] {
            let run = after(&folder, setting, "build m.json -o b.svg -o a.step");
            assert!(run.code == 3 && run.stderr.contains("file too large"), "{} {}", run.code, run.stderr);
            assert_eq!(
                (names(&folder), folder.read("a.step")),
                (vec!["a.step".into(), "m.json".into()], b"old".into())
            );
        }
    }

    /// Kills the program at any time, half of the times near the step at which the files take their places, first at once and last when
    /// it is done, so that no load of the machine makes all of them too late or too early; gives how often the old set was there
    /// afterwards, and how often the new one.
    fn killed(folder: &Folder, set: &str, commands: [&str; 2], kills: u32) -> [usize; 2] {
        let contents = commands.map(|command| {
            folder.ok(command);
            content(&folder.path(set))
        });
        let begin = Instant::now();
        folder.ok(commands[1]);
        let whole = begin.elapsed();
        let mut state = 1_u64;
        let mut random = |below: Duration| {
            state = state.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
            below.mul_f64((state >> 11) as f64 / (1_u64 << 53) as f64)
        };
        let mut counts = [0, 0];
        for kill in 0..kills {
            // Of two sets in turn, so that nothing is there already.
            let found = content(&folder.path(set));
            let command = commands[usize::from(found == contents[0])];
            let mut child = folder
                .command()
                .args(command.split_whitespace())
                .stdout(Stdio::piped())
                .stderr(Stdio::null())
                .spawn()
                .unwrap();
            let stdout = child.stdout.as_mut().unwrap();
            if kill == kills - 1 {
                stdout.read_to_end(&mut Vec::new()).unwrap();
            } else if kill % 2 == 1 {
                // The report is printed just before.
                let _ = stdout.read(&mut [0]);
                std::thread::sleep(random(Duration::from_millis(2)));
            } else if kill > 0 {
                std::thread::sleep(random(whole));
            }
            child.kill().unwrap();
            child.wait().unwrap();
            let after = content(&folder.path(set));
            assert!(contents.contains(&after), "kill {kill}: a mixed set: {:?}", after.keys().collect::<Vec<_>>());
            counts[usize::from(after != found)] += 1;
        }
        counts
    }

    /// Kills of a set in the suite; 300 for a release: `CYCLIDE_KILLS=300`.
    fn kills() -> u32 {
        std::env::var("CYCLIDE_KILLS").ok().and_then(|text| text.parse().ok()).unwrap_or(30)
    }

    #[test]
    fn a_killed_run_leaves_the_old_set_or_the_new_one() {
        let net = |width: f64| {
            format!(
                r#"{{"cyclide": 1, "units": "m", "objects": {{"skin": {{"type": "cyclidic-net", "grid":
                [[[0, 0, 0], [1, 0, 0], [{width}, 0, 0]], [[0, 1, 0], [1, 1, 0], [{width}, 1, 0]]]}}}}}}"#
            )
        };
        let folder = Folder::with(&[
            ("a.json", &net(2.0)),
            ("b.json", &net(3.0)),
            ("c.json", &circles(30, 1.0)),
            ("d.json", &circles(30, 2.0)),
        ]);
        let schedules = ["schedule a.json -o workshop", "schedule b.json -o workshop"];
        let [old, new] = killed(&folder, "workshop", schedules, kills());
        assert!(old > 0 && new > 0, "{old} old, {new} new");
        std::fs::create_dir(folder.path("out")).unwrap();
        let objects = ["build c.json --per-object -o out/p.svg", "build d.json --per-object -o out/p.svg"];
        let [old, new] = killed(&folder, "out", objects, kills());
        assert!(old > 0 && new > 0, "{old} old, {new} new");
        // What they left beside the folders the next run removes.
        folder.ok(schedules[0]);
        folder.ok(objects[0]);
        assert_eq!(names(&folder), ["a.json", "b.json", "c.json", "d.json", "out", "workshop"]);
    }

    #[test]
    fn a_folder_with_other_things_keeps_them() {
        let folder = Folder::with(&[("c.json", &circles(3, 1.0))]);
        std::fs::create_dir_all(folder.path("out/mine")).unwrap();
        folder.write("out/notes.txt", "mine");
        folder.ok("build c.json --per-object -o out/p.svg");
        folder.ok("build c.json --per-object -o out/p.svg");
        assert_eq!(folder.read("out/notes.txt"), b"mine");
        assert!(folder.has("out/mine") && folder.has("out/p-c2.svg"));
        // The folder that somebody is in is not exchanged.
        let inside = folder.path("inside");
        std::fs::create_dir(&inside).unwrap();
        for _ in 0..2 {
            let number = std::os::unix::fs::MetadataExt::ino(&std::fs::metadata(&inside).unwrap());
            let mut command = folder.command();
            command.current_dir(&inside).args(["build", "../c.json", "--per-object", "-o", "./p.svg"]);
            assert!(command.output().unwrap().status.success());
            assert_eq!(std::os::unix::fs::MetadataExt::ino(&std::fs::metadata(&inside).unwrap()), number);
        }
        assert!(
            folder.fails(3, "build c.json --per-object -o nowhere/p.svg").contains("the folder nowhere does not exist")
        );
    }
}
