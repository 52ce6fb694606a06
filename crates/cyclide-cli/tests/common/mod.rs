//! A folder of its own for each test, and the program run in it.

#![allow(dead_code, reason = "each test file uses its part")]

use std::path::{Path, PathBuf};
use std::process::{Command, Output, Stdio};

use tempfile::TempDir;

/// A folder that is gone after the test.
pub struct Folder(TempDir);

/// What a run left behind.
pub struct Run {
    pub code: i32,
    pub stdout: String,
    pub stderr: String,
}

impl Folder {
    /// A new folder with these files.
    pub fn with(files: &[(&str, &str)]) -> Self {
        let folder = Self(tempfile::tempdir().expect("a temporary folder"));
        for (name, text) in files {
            folder.write(name, text);
        }
        folder
    }

    pub fn path(&self, name: &str) -> PathBuf {
        self.0.path().join(name)
    }

    pub fn write(&self, name: &str, text: &str) {
        std::fs::write(self.path(name), text).expect("a file is written");
    }

    pub fn read(&self, name: &str) -> Vec<u8> {
        std::fs::read(self.path(name)).expect("a file is read")
    }

    pub fn has(&self, name: &str) -> bool {
        self.path(name).exists()
    }

    /// Number of files in the folder.
    pub fn count(&self) -> usize {
        std::fs::read_dir(self.0.path()).expect("the folder is read").count()
    }

    /// Runs `cyclide` here; arguments are separated by blanks.
    pub fn run(&self, arguments: &str) -> Run {
        Run::new(self.command().args(arguments.split_whitespace()).output().expect("cyclide runs"))
    }

    /// Runs it and expects success; gives standard output.
    pub fn ok(&self, arguments: &str) -> String {
        let run = self.run(arguments);
        assert_eq!(run.code, 0, "cyclide {arguments}\n{}", run.stderr);
        run.stdout
    }

    /// Runs it, expects success, and reads standard output as JSON.
    pub fn json(&self, arguments: &str) -> serde_json::Value {
        serde_json::from_str(&self.ok(arguments)).expect("the report is JSON")
    }

    /// Runs it and expects this exit code; gives standard error.
    pub fn fails(&self, code: i32, arguments: &str) -> String {
        let run = self.run(arguments);
        assert_eq!(run.code, code, "cyclide {arguments}\n{}{}", run.stdout, run.stderr);
        assert_eq!(run.stdout, "", "a failed run prints no result");
        run.stderr
    }

    pub fn command(&self) -> Command {
        let mut command = Command::new(env!("CARGO_BIN_EXE_cyclide"));
        command.current_dir(self.0.path()).stdin(Stdio::null()).env_remove("CLICOLOR_FORCE");
        command
    }
}

impl Run {
    pub fn new(output: Output) -> Self {
        let text = |bytes| String::from_utf8(bytes).expect("the output is UTF-8");
        let code = output.status.code().expect("the run ended by itself");
        Self { code, stdout: text(output.stdout), stderr: text(output.stderr) }
    }
}

/// A file of the project.
pub fn project(path: &str) -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("../..").join(path)
}
