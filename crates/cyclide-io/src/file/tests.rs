use super::*;

use std::fs;

fn plain(path: &Path, bytes: &[u8]) -> io::Result<()> {
    write_file(path, bytes, WriteOptions::default())
}

#[test]
fn replaces_whole_files_and_leaves_nothing_else() {
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("a.svg");
    plain(&path, b"old").unwrap();
    write_file(&path, b"new", WriteOptions { durable: true, force: false }).unwrap();
    assert_eq!(fs::read(&path).unwrap(), b"new");
    assert_eq!(fs::read_dir(folder.path()).unwrap().count(), 1);
}

#[test]
fn a_failed_run_leaves_the_old_file() {
    let folder = tempfile::tempdir().unwrap();
    // A folder of the same name cannot be replaced by a file.
    let path = folder.path().join("taken");
    fs::create_dir(&path).unwrap();
    fs::write(path.join("inside"), b"old").unwrap();
    assert!(plain(&path, b"new").is_err());
    assert_eq!(fs::read(path.join("inside")).unwrap(), b"old");
    assert_eq!(fs::read_dir(folder.path()).unwrap().count(), 1);
    assert!(plain(&folder.path().join("no/such/folder"), b"x").is_err());
}

#[test]
fn all_are_complete_before_the_first_takes_its_place() {
    let folder = tempfile::tempdir().unwrap();
    let [a, b] = ["a", "b"].map(|name| folder.path().join(name));
    fs::write(&a, b"old").unwrap();
    let files = [(&a, b"new a"), (&b, b"new b")];
    let staged = StagedFiles::new(&files, WriteOptions::default()).unwrap();
    assert_eq!((fs::read(&a).unwrap(), b.exists()), (b"old".to_vec(), false));
    drop(staged);
    assert_eq!(fs::read_dir(folder.path()).unwrap().count(), 1, "what is not committed leaves nothing");
    // Something gets into the way of the second rename: the first takes its old content again.
    let staged = StagedFiles::new(&files, WriteOptions::default()).unwrap();
    fs::create_dir(&b).unwrap();
    let failed = staged.commit().unwrap_err();
    assert_eq!((failed.index, failed.written.len(), fs::read(&a).unwrap()), (1, 0, b"old".to_vec()));
    assert_eq!(fs::read_dir(folder.path()).unwrap().count(), 2, "no temporary file is left");
    // A new one is gone again.
    fs::remove_file(&a).unwrap();
    let failed = StagedFiles::new(&files[..1], WriteOptions::default()).unwrap().commit();
    assert!(failed.is_ok());
    let new = folder.path().join("new");
    let files = [(&new, b"new a"), (&b, b"new b")];
    fs::remove_dir(&b).unwrap();
    let staged = StagedFiles::new(&files, WriteOptions::default()).unwrap();
    fs::create_dir(&b).unwrap();
    assert!(staged.commit().is_err() && !new.exists());
}

#[test]
fn a_name_that_ends_in_a_separator_is_no_file() {
    let folder = tempfile::tempdir().unwrap();
    for name in ["a.step/", "a.step/."] {
        assert_eq!(plain(&folder.path().join(name), b"x").unwrap_err().kind(), io::ErrorKind::IsADirectory, "{name}");
    }
    assert_eq!(fs::read_dir(folder.path()).unwrap().count(), 0);
}

#[cfg(unix)]
#[test]
fn a_folder_that_cannot_be_synced_leaves_the_files_written_and_says_so() {
    let folder = tempfile::tempdir().unwrap();
    let gone = folder.path().join("gone");
    let error = sync_folder(&gone).unwrap_err();
    assert!(error.get_ref().is_some_and(|inner| inner.is::<NotDurable>()));
    let start = format!("all files are written, but they may not survive a power failure: folder {}: ", gone.display());
    assert!(error.to_string().starts_with(&start), "{error}");
}

#[test]
fn one_file_by_any_name_is_the_same() {
    let folder = tempfile::tempdir().unwrap();
    let at = |name: &str| folder.path().join(name);
    fs::write(at("a"), b"").unwrap();
    fs::write(at("other"), b"").unwrap();
    assert!(same_file(&at("a"), &at("./a")) && !same_file(&at("a"), &at("other")));
    assert!(same_file(&at("new"), &at("./new")) && !same_file(&at("new"), &at("newer")), "before they exist");
    assert!(same_file(Path::new("new"), Path::new("./new")));
    assert!(!same_file(&at("new"), &at("a")));
}

#[cfg(unix)]
mod unix {
    use super::*;
    use std::os::unix::fs::{FileTypeExt as _, MetadataExt as _, PermissionsExt as _, symlink};

    fn mode(path: &Path) -> u32 {
        fs::metadata(path).unwrap().mode() & 0o7777
    }

    #[test]
    fn a_link_stays_and_its_target_is_replaced() {
        let folder = tempfile::tempdir().unwrap();
        let at = |name: &str| folder.path().join(name);
        fs::create_dir(at("far")).unwrap();
        fs::write(at("far/target"), b"old").unwrap();
        symlink("far/target", at("one")).unwrap();
        symlink("one", at("two")).unwrap();
        symlink("far/new", at("dangling")).unwrap();
        plain(&at("two"), b"new").unwrap();
        plain(&at("dangling"), b"made").unwrap();
        for link in ["one", "two", "dangling"] {
            assert!(fs::symlink_metadata(at(link)).unwrap().is_symlink(), "{link}");
        }
        assert_eq!(fs::read(at("far/target")).unwrap(), b"new");
        assert_eq!(fs::read(at("far/new")).unwrap(), b"made");
        assert!(same_file(&at("two"), &at("far/target")) && same_file(&at("dangling"), &at("far/new")));
        // In a circle they lead nowhere.
        symlink("circle", at("circle")).unwrap();
        assert!(plain(&at("circle"), b"x").is_err());
    }

    #[test]
    fn devices_and_links_to_them_are_written_into() {
        let folder = tempfile::tempdir().unwrap();
        let link = folder.path().join("null");
        symlink("/dev/null", &link).unwrap();
        plain(&link, b"x").unwrap();
        plain(Path::new("/dev/null"), b"x").unwrap();
        assert!(fs::metadata("/dev/null").unwrap().file_type().is_char_device());
        assert!(fs::symlink_metadata(&link).unwrap().is_symlink());
        assert_eq!(fs::read_dir(folder.path()).unwrap().count(), 1);
        if Path::new("/dev/full").exists() {
            assert!(plain(Path::new("/dev/full"), b"x").is_err());
        }
    }

    #[test]
    fn a_pipe_is_written_into() {
        let folder = tempfile::tempdir().unwrap();
        let pipe = folder.path().join("pipe.step");
        if !std::process::Command::new("mkfifo").arg(&pipe).status().is_ok_and(|status| status.success()) {
            return;
        }
        let reader = std::thread::spawn({
            let pipe = pipe.clone();
            move || fs::read(pipe).unwrap()
        });
        plain(&pipe, b"through the pipe").unwrap();
        assert_eq!(reader.join().unwrap(), b"through the pipe");
        assert!(fs::symlink_metadata(&pipe).unwrap().file_type().is_fifo());
    }

    #[test]
    fn rights_and_owner_of_the_old_file_are_kept() {
        let folder = tempfile::tempdir().unwrap();
        let path = folder.path().join("a");
        fs::write(&path, b"old").unwrap();
        // More than the usual mask leaves, and less.
        for rights in [0o666, 0o664, 0o600, 0o640, 0o755] {
            fs::set_permissions(&path, fs::Permissions::from_mode(rights)).unwrap();
            plain(&path, b"new").unwrap();
            assert_eq!(mode(&path), rights, "{rights:o}");
        }
        // Only the administrator may give files away.
        if std::os::unix::fs::chown(&path, Some(12_345), Some(23_456)).is_ok() {
            plain(&path, b"newer").unwrap();
            let found = fs::metadata(&path).unwrap();
            assert_eq!((found.uid(), found.gid(), mode(&path)), (12_345, 23_456, 0o755));
        }
    }

    #[test]
    fn a_read_only_file_is_replaced_by_force_alone() {
        let folder = tempfile::tempdir().unwrap();
        let path = folder.path().join("a");
        fs::write(&path, b"old").unwrap();
        fs::set_permissions(&path, fs::Permissions::from_mode(0o444)).unwrap();
        let error = plain(&path, b"new").unwrap_err();
        assert_eq!(error.kind(), io::ErrorKind::PermissionDenied);
        assert!(error.to_string().contains("read-only"), "{error}");
        assert_eq!(fs::read(&path).unwrap(), b"old");
        write_file(&path, b"new", WriteOptions { force: true, durable: false }).unwrap();
        assert_eq!((fs::read(&path).unwrap(), mode(&path)), (b"new".to_vec(), 0o444));
        assert_eq!(fs::read_dir(folder.path()).unwrap().count(), 1);
    }

    #[test]
    fn temporary_files_that_nobody_holds_are_removed() {
        let folder = tempfile::tempdir().unwrap();
        let at = |name: &str| folder.path().join(name);
        let stays = [".cyclide-short", ".cyclide-12-45678", "cyclide-ABCD1234", ".other-ABCD1234"];
        for name in stays {
            fs::create_dir(at(name)).unwrap();
        }
        fs::write(at(".cyclide-abcd1234"), b"no folder").unwrap();
        fs::create_dir(at(".cyclide-ABCD1234")).unwrap();
        fs::write(at(".cyclide-ABCD1234/new-0"), b"left by a run that was killed").unwrap();
        let files = [(at("a"), b"held")];
        let held = StagedFiles::new(&files, WriteOptions::default()).unwrap();
        assert!(!at(".cyclide-ABCD1234").exists());
        plain(&at("a"), b"new").unwrap();
        // The file of a run that is under way stays, and takes its place.
        held.commit().unwrap();
        assert_eq!(fs::read(at("a")).unwrap(), b"held");
        let mut left: Vec<_> =
            fs::read_dir(folder.path()).unwrap().map(|e| e.unwrap().file_name().into_string().unwrap()).collect();
        left.sort();
        let mut expected = [&stays[..], &["a", ".cyclide-abcd1234"]].concat();
        expected.sort_unstable();
        assert_eq!(left, expected);
    }

    #[test]
    fn a_folder_is_exchanged_as_one_and_keeps_its_rights() {
        let all = tempfile::tempdir().unwrap();
        let at = |name: &str| all.path().join(name);
        let files = ["a", "b"].map(|name| (at("set").join(name), name));
        let write = |files: &[(PathBuf, &str)]| StagedFiles::whole_folder(files, WriteOptions::default())?.commit();
        let number = || fs::metadata(at("set")).unwrap().ino();
        write(&files).unwrap();
        fs::set_permissions(at("set"), fs::Permissions::from_mode(0o2750)).unwrap();
        fs::set_permissions(at("set/a"), fs::Permissions::from_mode(0o640)).unwrap();
        let first = number();
        write(&files[..1]).unwrap();
        assert_eq!((number(), at("set/b").exists()), (first, true), "b is not of this set: one by one");
        write(&files).unwrap();
        assert_eq!((mode(&at("set")), mode(&at("set/a"))), (0o2750, 0o640));
        // A link to the folder stays one.
        symlink("set", at("link")).unwrap();
        let linked = ["a", "b"].map(|name| (at("link").join(name), "new"));
        write(&linked).unwrap();
        assert!(fs::symlink_metadata(at("link")).unwrap().is_symlink());
        assert_eq!(fs::read(at("set/b")).unwrap(), b"new");
        // A link in it, a file with two names, or a read-only file.
        fs::hard_link(at("set/a"), at("second")).unwrap();
        let before = number();
        write(&files).unwrap();
        assert_eq!((number(), fs::read(at("second")).unwrap()), (before, b"new".to_vec()));
        fs::remove_file(at("set/b")).unwrap();
        symlink("../second", at("set/b")).unwrap();
        write(&files).unwrap();
        assert!(fs::symlink_metadata(at("set/b")).unwrap().is_symlink());
        assert_eq!(fs::read(at("second")).unwrap(), b"b");
        fs::set_permissions(at("set/a"), fs::Permissions::from_mode(0o440)).unwrap();
        assert_eq!(write(&files).unwrap_err().error.kind(), io::ErrorKind::PermissionDenied);
        assert_eq!(fs::read_dir(all.path()).unwrap().count(), 3);
    }

    #[test]
    fn names_as_long_as_file_systems_take_are_written() {
        let folder = tempfile::tempdir().unwrap();
        let [a, b] = ["a", "b"].map(|last| folder.path().join("é".repeat(127) + last));
        plain(&a, b"a").unwrap();
        plain(&b, b"b").unwrap();
        assert_eq!((fs::read(&a).unwrap(), fs::read(&b).unwrap()), (b"a".to_vec(), b"b".to_vec()));
    }
}
