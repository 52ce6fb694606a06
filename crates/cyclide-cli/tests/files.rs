//! What happens to files: written whole or not at all, never over what is no file; standard input and output.

#![allow(clippy::unwrap_used, clippy::expect_used, clippy::panic, reason = "a test fails by panicking")]

mod common;

use std::fs;
use std::io::Write as _;
use std::process::Stdio;
use std::time::{Duration, Instant};

use common::{Folder, Run};

const CIRCLE: &str = r#"{"cyclide": 1, "objects": {"c": {"type": "circle", "center": [0, 0], "radius": 1}}}"#;
const POINTS: &str = "x,y\n0,0\n1,0\n1,1\n";

/// Runs it with this standard input.
fn piped(folder: &Folder, arguments: &str, input: &[u8]) -> Run {
    let mut command = folder.command();
    command.args(arguments.split_whitespace()).stdin(Stdio::piped()).stdout(Stdio::piped()).stderr(Stdio::piped());
    let mut child = command.spawn().unwrap();
    let mut stdin = child.stdin.take().unwrap();
    let input = input.to_vec();
    // The program may stop before it has read everything.
    let writer = std::thread::spawn(move || drop(stdin.write_all(&input)));
    let run = Run::new(child.wait_with_output().unwrap());
    writer.join().unwrap();
    run
}

#[test]
fn standard_input_is_a_document_or_points() {
    let folder = Folder::with(&[("c.json", CIRCLE), ("p.csv", POINTS)]);
    folder.ok("build c.json -o a.step");
    let run = piped(&folder, "build - -o b.step", CIRCLE.as_bytes());
    assert_eq!((run.code, run.stderr.as_str()), (0, ""));
    assert_eq!(folder.read("a.step"), folder.read("b.step"));
    let run = piped(&folder, "curve - -o c.svg", POINTS.as_bytes());
    assert_eq!((run.code, run.stderr.as_str()), (0, ""));
    assert!(run.stdout.contains("curve"), "{}", run.stdout);
    assert!(piped(&folder, "report -", CIRCLE.as_bytes()).stdout.contains("circle"));
    assert!(piped(&folder, "sample - --count 3", CIRCLE.as_bytes()).stdout.starts_with("t,x,y,z"));
    // What it is is told by its content.
    let run = piped(&folder, "build - -o d.step", POINTS.as_bytes());
    assert!(run.code == 2 && run.stderr.contains("standard input seems to be a list of points"), "{}", run.stderr);
    let run = piped(&folder, "curve - -o d.step", b"x,y\n0,0\n1,z\n");
    assert!(
        run.code == 1 && run.stderr.starts_with("error: standard input:3:3: `z` is not a number"),
        "{}",
        run.stderr
    );
    // A document may name it in the place of a file, but for one that comes from there itself.
    let document = r#"{"cyclide": 1, "objects": {"c": {"type": "arc-spline", "points": {"csv": "-"}},
        "d": {"type": "fair-spline", "points": {"csv": "-"}}}}"#;
    folder.write("m.json", document);
    assert_eq!(piped(&folder, "build m.json -o e.step", POINTS.as_bytes()).code, 0);
    let run = piped(&folder, "build - -o f.step", document.as_bytes());
    assert!(run.code == 2 && run.stderr.contains("standard input is the document"), "{}", run.stderr);
}

#[test]
fn standard_output_takes_one_file_and_the_report_goes_aside() {
    let folder = Folder::with(&[("c.json", CIRCLE), ("p.csv", POINTS)]);
    folder.ok("build c.json -o a.step");
    let run = folder.run("build c.json -o - --format step");
    assert_eq!((run.code, run.stdout.as_bytes()), (0, &folder.read("a.step")[..]));
    assert!(run.stderr.contains("length"), "{}", run.stderr);
    let run = folder.run("curve p.csv -o - --format svg --json");
    assert!(run.stdout.contains("</svg>") && run.stderr.starts_with('{'), "{}", run.stderr);
    assert_eq!(folder.ok("sample c.json --count 3 -o -"), folder.ok("sample c.json --count 3"));
    assert_eq!(folder.ok("new arc -o -"), folder.ok("new arc"));
    for (command, message) in [
        ("build c.json -o -", "-o - needs --format: one of step, dxf"),
        ("build c.json -o - --format iges", "possible values: step, dxf"),
        ("build c.json -o - -o b.step --format step", "`-o -` must be the only output"),
        ("build c.json -o a.step --format dxf", "a.step: the suffix means step, but --format is dxf"),
    ] {
        let error = folder.fails(2, command);
        assert!(error.contains(message), "{command}\n{error}");
    }
    #[cfg(unix)]
    assert_eq!(folder.run("build c.json -o /dev/stdout --format step").stdout.as_bytes(), folder.read("a.step"));
    // Names without a suffix have the format that was told.
    folder.ok("build c.json -o plain --format step");
    assert_eq!(folder.read("plain"), folder.read("a.step"));
    assert!(!folder.has("-"));
}

#[test]
fn one_file_by_two_names_is_one_output() {
    let folder = Folder::with(&[("c.json", CIRCLE), ("old.step", "old")]);
    let second = ["./new.step", "sub/../new.step"];
    fs::create_dir(folder.path("sub")).unwrap();
    for name in second {
        let error = folder.fails(2, &format!("build c.json -o new.step -o {name}"));
        assert!(error.contains("is given twice: it is the same file as new.step"), "{error}");
    }
    #[cfg(unix)]
    {
        std::os::unix::fs::symlink("old.step", folder.path("link.step")).unwrap();
        fs::hard_link(folder.path("old.step"), folder.path("other.step")).unwrap();
        for name in ["link.step", "other.step"] {
            assert!(folder.fails(2, &format!("build c.json -o old.step -o {name}")).contains("given twice"));
        }
        std::os::unix::fs::symlink("c.json", folder.path("model.json")).unwrap();
        assert!(folder.fails(2, "build c.json -o model.json").contains("model.json is an input"));
    }
    assert_eq!(folder.read("old.step"), b"old");
}

#[cfg(unix)]
mod unix {
    use super::*;
    use std::fs::Permissions;
    use std::os::unix::fs::{FileTypeExt as _, PermissionsExt as _, symlink};
    use std::path::Path;

    #[test]
    fn devices_and_pipes_are_written_into_and_stay() {
        let folder = Folder::with(&[("c.json", CIRCLE)]);
        symlink("/dev/null", folder.path("null.step")).unwrap();
        folder.ok("build c.json -o null.step");
        folder.ok("build c.json -o /dev/null --format step");
        assert!(fs::metadata("/dev/null").unwrap().file_type().is_char_device());
        assert!(fs::symlink_metadata(folder.path("null.step")).unwrap().is_symlink());
        if Path::new("/dev/full").exists() {
            let run = folder.run("build c.json -o /dev/full --format step");
            assert!(run.code == 3 && run.stderr.contains("cannot write /dev/full"), "{}", run.stderr);
        }
        let pipe = folder.path("pipe.step");
        if std::process::Command::new("mkfifo").arg(&pipe).status().is_ok_and(|status| status.success()) {
            let reader = std::thread::spawn({
                let pipe = pipe.clone();
                move || fs::read(pipe).unwrap()
            });
            folder.ok("build c.json -o pipe.step");
            assert!(reader.join().unwrap().starts_with(b"ISO-10303-21;"));
            assert!(fs::symlink_metadata(&pipe).unwrap().file_type().is_fifo());
            // Nobody writes into it now: a reader would wait for ever.
            fs::rename(&pipe, folder.path("pipe.csv")).unwrap();
            folder.write(
                "m.json",
                &CIRCLE.replace(
                    r#""circle", "center": [0, 0], "radius": 1"#,
                    r#""arc-spline", "points": {"csv": "pipe.csv"}"#,
                ),
            );
            for command in ["curve pipe.csv -o a.step", "build m.json -o a.step"] {
                let error = folder.fails(3, command);
                assert!(error.contains("cannot read pipe.csv: it is not a regular file"), "{error}");
            }
        }
        symlink("/dev/zero", folder.path("zero.csv")).unwrap();
        assert!(folder.fails(3, "curve zero.csv -o a.step").contains("not a regular file"));
        assert!(folder.fails(3, "build . -o a.step").contains("cannot read .: it is a folder"));
    }

    #[test]
    fn the_file_behind_standard_input_is_not_written_over() {
        let folder = Folder::with(&[("p.csv", POINTS), ("c.json", CIRCLE)]);
        symlink("c.json", folder.path("link.csv")).unwrap();
        let document = r#"{"cyclide": 1, "objects": {"c": {"type": "arc-spline", "points": {"csv": "-"}}}}"#;
        folder.write("m.json", document);
        for (input, output, command) in [
            ("p.csv", "p.csv", "curve - -o p.csv"),
            ("p.csv", "./p.csv", "curve /dev/stdin -o new.step -o ./p.csv"),
            ("p.csv", "p.csv", "curve /dev/fd/0 -o p.csv"),
            ("c.json", "c.json", "build - -o c.json"),
            ("c.json", "link.csv", "sample - --count 3 -o link.csv"),
            ("p.csv", "p.csv", "build m.json -o p.csv"),
            ("p.csv", "p.csv", "sample m.json --count 3 -o p.csv"),
        ] {
            let before = folder.read(input);
            let stdin = fs::File::open(folder.path(input)).unwrap();
            let run = Run::new(folder.command().args(command.split_whitespace()).stdin(stdin).output().unwrap());
            let message = format!("{output} is an input and will not be overwritten");
            assert!(run.code == 2 && run.stderr.contains(&message), "{command}: {}", run.stderr);
            assert_eq!(folder.read(input), before, "{command}");
        }
        // Other files are written, and so is the null device when it is the input too.
        let stdin = fs::File::open(folder.path("c.json")).unwrap();
        let run = folder.command().args(["build", "-", "-o", "a.step"]).stdin(stdin).output().unwrap();
        assert!(run.status.success() && folder.has("a.step"));
        folder.ok("build c.json -o /dev/null --format step");
    }

    #[test]
    fn every_name_of_standard_output_takes_the_file_alone() {
        let folder = Folder::with(&[("c.json", CIRCLE)]);
        folder.ok("build c.json -o a.step");
        let step = folder.read("a.step");
        symlink("/dev/fd/1", folder.path("link.step")).unwrap();
        for name in ["/dev/fd/1", "/proc/self/fd/1", "link.step"] {
            if !folder.path(name).exists() && name != "link.step" {
                continue;
            }
            let run = folder.run(&format!("build c.json -o {name} --format step"));
            assert_eq!((run.code, run.stdout.as_bytes()), (0, &step[..]), "{name}: {}", run.stderr);
            assert!(run.stderr.contains("length"), "{name}: {}", run.stderr);
            let error = folder.fails(2, &format!("build c.json -o b.step -o {name} --format step"));
            assert!(error.contains("standard output takes one file"), "{name}: {error}");
        }
        assert_eq!(folder.ok("sample c.json --count 3 -o /dev/fd/1"), folder.ok("sample c.json --count 3"));
        // The file behind `>` has the content, not the report.
        let behind = fs::File::create(folder.path("b.step")).unwrap();
        let run = folder.command().args(["build", "c.json", "-o", "b.step"]).stdout(behind).output().unwrap();
        assert_eq!((run.status.code(), folder.read("b.step")), (Some(0), step));
        assert!(String::from_utf8_lossy(&run.stderr).contains("length"));
        // In the null device nothing gets mixed: files beside it are written.
        let arguments = ["build", "c.json", "-o", "c.step", "-o", "/dev/null", "--format", "step"];
        let run = folder.command().args(arguments).stdout(Stdio::null()).output().unwrap();
        assert!(run.status.success() && run.stderr.is_empty() && folder.has("c.step"));
    }

    #[test]
    fn links_stay_and_rights_are_kept() {
        let folder = Folder::with(&[("c.json", CIRCLE), ("target", "old")]);
        symlink("target", folder.path("link.step")).unwrap();
        fs::set_permissions(folder.path("target"), Permissions::from_mode(0o664)).unwrap();
        folder.ok("build c.json -o link.step --durable");
        assert!(fs::symlink_metadata(folder.path("link.step")).unwrap().is_symlink());
        assert!(folder.read("target").starts_with(b"ISO-10303-21;"));
        assert_eq!(fs::metadata(folder.path("target")).unwrap().permissions().mode() & 0o7777, 0o664);
    }

    #[test]
    fn read_only_files_are_replaced_by_force_alone() {
        let folder = Folder::with(&[("c.json", CIRCLE), ("a.step", "old"), ("b.csv", "old")]);
        for name in ["a.step", "b.csv"] {
            fs::set_permissions(folder.path(name), Permissions::from_mode(0o444)).unwrap();
        }
        for command in ["build c.json -o new.svg -o a.step", "sample c.json --count 3 -o b.csv"] {
            let error = folder.fails(3, command);
            assert!(error.contains("read-only (--force replaces it)"), "{error}");
        }
        assert_eq!(
            (folder.read("a.step"), folder.read("b.csv"), folder.has("new.svg")),
            (b"old".into(), b"old".into(), false)
        );
        folder.ok("build c.json -o a.step --force");
        folder.ok("sample c.json --count 3 -o b.csv --force");
        assert!(folder.read("a.step").starts_with(b"ISO") && folder.read("b.csv").starts_with(b"t,x"));
    }

    #[test]
    fn standard_output_that_cannot_be_written_leaves_the_old_files() {
        let Ok(full) = fs::File::options().write(true).open("/dev/full") else { return };
        let folder = Folder::with(&[("c.json", CIRCLE), ("a.step", "old")]);
        let run =
            folder.command().args(["build", "c.json", "-o", "a.step", "-o", "b.svg"]).stdout(full).output().unwrap();
        assert_eq!(run.status.code(), Some(3));
        assert!(String::from_utf8_lossy(&run.stderr).contains("cannot write standard output"));
        assert_eq!((folder.read("a.step"), folder.has("b.svg"), folder.count()), (b"old".to_vec(), false, 2));
    }

    #[test]
    fn what_a_killed_run_left_is_removed_by_the_next_one() {
        let folder = Folder::with(&[("c.json", CIRCLE)]);
        // The run waits for a reader of the pipe, with the file before it under its temporary name.
        let pipe = folder.path("pipe.svg");
        if !std::process::Command::new("mkfifo").arg(&pipe).status().is_ok_and(|status| status.success()) {
            return;
        }
        let arguments = ["build", "c.json", "-o", "pipe.svg", "-o", "a.step"];
        let mut child = folder.command().args(arguments).stdout(Stdio::null()).spawn().unwrap();
        let begin = Instant::now();
        let temporaries = || {
            let names = fs::read_dir(folder.path(".")).unwrap().map(|e| e.unwrap().file_name().into_string().unwrap());
            names.filter(|name| name.starts_with(".cyclide-")).count()
        };
        while temporaries() == 0 && begin.elapsed() < Duration::from_secs(60) {
            std::thread::sleep(Duration::from_millis(5));
        }
        // One that is under way is left alone.
        folder.ok("build c.json -o a.step");
        assert_eq!(temporaries(), 1);
        child.kill().unwrap();
        child.wait().unwrap();
        assert_eq!(temporaries(), 1, "killed, it could not remove its file");
        folder.ok("build c.json -o a.step");
        assert_eq!(temporaries(), 0);
        assert!(folder.read("a.step").starts_with(b"ISO"));
    }
}

#[test]
fn input_of_any_size_is_refused() {
    let folder = Folder::with(&[]);
    let digits = "7".repeat(100_000_000);
    let long_string = format!(r#"{{"cyclide": 1, "comment": "{}", "objects": {{}}}}"#, "x y ".repeat(2_500_000));
    let long_number =
        format!(r#"{{"cyclide": 1, "objects": {{"c": {{"type": "circle", "radius": {}}}}}}}"#, &digits[..10_000_000]);
    for (name, text, command, message) in [
        ("d.json", digits.clone(), "build d.json -o o.step", "the number or word is longer than 2048 bytes"),
        ("d.csv", digits.clone(), "curve d.csv -o o.step", "the line has 100000000 bytes, maximum 65536"),
        ("n.json", long_number, "build n.json -o o.step", "the number or word is longer than 2048 bytes"),
        ("s.json", long_string, "build s.json -o o.step", "the string is longer than 65536 bytes"),
        ("c.csv", format!("x,y\n{}", "1,".repeat(50_000_000)), "curve c.csv -o o.step", "the line has 100000000 bytes"),
        (
            "l.json",
            format!("{{\"cyclide\": {}", "[".repeat(100_000_000)),
            "build l.json -o o.step",
            "more than 64 levels deep",
        ),
        ("b.csv", "\n".repeat(100_000_000), "curve b.csv -o o.step", "the file has no points"),
    ] {
        folder.write(name, &text);
        let error = folder.fails(1, command);
        assert!(error.contains(message) && error.len() < 600, "{name}: {error}");
        fs::remove_file(folder.path(name)).unwrap();
    }
    // A file that is larger than any is not read at all.
    fs::File::create(folder.path("hole.csv")).unwrap().set_len(1 << 33).unwrap();
    assert!(folder.fails(3, "curve hole.csv -o o.step").contains("it has 8589934592 bytes, maximum 536870912"));
}

#[test]
fn each_object_has_a_file_of_its_own() {
    let circle = |x: u32| format!(r#"{{"type": "circle", "center": [{x}, 0], "radius": 1}}"#);
    let document =
        |a: &str, b: &str| format!(r#"{{"cyclide": 1, "objects": {{"{a}": {}, "{b}": {}}}}}"#, circle(0), circle(5));
    let folder = Folder::with(&[("m.json", &document("left side", "right"))]);
    let report = folder.json("build m.json -o o.vtu -o o.dxf --per-object --json");
    let files: Vec<&str> = report["files"].as_array().unwrap().iter().map(|f| f["path"].as_str().unwrap()).collect();
    assert_eq!(files, ["o-left_side.vtu", "o-left_side.dxf", "o-right.vtu", "o-right.dxf", "o.vtm"]);
    assert_eq!(report["files"][4]["bytes"].as_u64(), Some(folder.read("o.vtm").len() as u64));
    // As the document with that object alone.
    folder.write("one.json", &format!(r#"{{"cyclide": 1, "objects": {{"right": {}}}}}"#, circle(5)));
    folder.ok("build one.json -o one.vtu");
    assert_eq!(folder.read("one.vtu"), folder.read("o-right.vtu"));
    let index = String::from_utf8(folder.read("o.vtm")).unwrap();
    assert!(index.contains(r#"<DataSet index="0" name="left side" file="o-left_side.vtu"/>"#), "{index}");
    assert!(!folder.path("o.vtu").exists() && !folder.path("o.dxf").exists());
    // Files of objects that the model has no more stay, which is said; a file of another name is somebody else's.
    folder.write("o-mine.step", "");
    let run = folder.run("build one.json -o o.dxf -o o.vtu --per-object");
    let said = "o-left_side.dxf and one other file belong to no object of this model and will stay";
    assert!(run.code == 0 && run.stderr.contains(said), "{}", run.stderr);
    let run = folder.run("build m.json -o o.dxf --per-object");
    assert!(folder.path("o-left_side.dxf").exists() && !run.stderr.contains("stay"), "{}", run.stderr);
    // Plain cells are those of blocks: what is none has no such file, and is not in the index.
    let block = r#"{"type": "cyclide-volume", "corners": [[0,0,0], [1,0,0], [0,1,0], [0,0,1]], "cells": 2}"#;
    folder.write("b.json", &format!(r#"{{"cyclide": 1, "objects": {{"block": {block}, "round": {}}}}}"#, circle(0)));
    let run = folder.run("build b.json -o q.vtu -o q.step --per-object --vtu-cells linear");
    assert!(run.code == 0 && run.stderr.contains("no such file is written for round [no-effect]"), "{}", run.stderr);
    assert!(folder.path("q-block.vtu").exists() && folder.path("q-round.step").exists());
    assert!(!folder.path("q-round.vtu").exists());
    assert!(!String::from_utf8(folder.read("q.vtm")).unwrap().contains("round"));
    // Nothing is written where two would be one, or to standard output.
    folder.write("two.json", &document("a b", "A_B"));
    let run = folder.run("build two.json -o p.vtu --per-object");
    assert!(
        run.code == 1 && run.stderr.contains("the files of `a b` and of `A_B` would have the same names"),
        "{}",
        run.stderr
    );
    assert!(!folder.path("p.vtm").exists() && !folder.path("p-a_b.vtu").exists());
    assert_eq!(folder.run("build m.json -o - --format vtu --per-object").code, 2);
    // A file that is read is not written over, whatever its name comes from.
    folder.write("o-right.json", &document("left", "right"));
    let run = folder.run("build o-right.json -o o.json --per-object");
    assert!(run.code == 2 && run.stderr.contains("will not be overwritten"), "{}", run.stderr);
}
