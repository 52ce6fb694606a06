//! Signals that end the program: it removes its temporary files first.
//!
//! They are watched from the moment on that there may be such files; before, the system ends the program as it does any. A signal that
//! the caller has told the program to ignore (`nohup`) stays ignored.

#[cfg(unix)]
pub fn remove_files_before_the_end() {
    watch::begin();
}

/// Elsewhere the system tells of no signals.
#[cfg(not(unix))]
pub fn remove_files_before_the_end() {}

#[cfg(unix)]
mod watch {
    use std::sync::atomic::AtomicBool;
    use std::sync::{Arc, Once};
    use std::thread;

    use cyclide_io::file::Abandoned;
    use signal_hook::consts::{SIGHUP, SIGINT, SIGQUIT, SIGTERM, SIGXFSZ};
    use signal_hook::iterator::Signals;
    use signal_hook::{flag, low_level};

    static ONCE: Once = Once::new();

    pub(super) fn begin() {
        ONCE.call_once(|| {
            // A file that grows beyond the limit of the process is an error of writing then.
            let _ = flag::register(SIGXFSZ, Arc::new(AtomicBool::new(false)));
            let ignored = ignored();
            let signals = [SIGHUP, SIGINT, SIGQUIT, SIGTERM];
            // What cannot be watched ends the program as before.
            let Ok(mut signals) = Signals::new(signals.iter().filter(|signal| ignored >> (**signal - 1) & 1 == 0))
            else {
                return;
            };
            thread::spawn(move || {
                if let Some(signal) = signals.forever().next() {
                    let _abandoned = Abandoned::all();
                    // The caller learns which signal it was.
                    let _ = low_level::emulate_default_handler(signal);
                }
            });
        });
    }

    /// The signals that the program was told to ignore, a bit for each from 1; none where the system does not say.
    fn ignored() -> u64 {
        let status = std::fs::read_to_string("/proc/self/status").unwrap_or_default();
        let mask = status.lines().find_map(|line| line.strip_prefix("SigIgn:"));
        mask.and_then(|mask| u64::from_str_radix(mask.trim(), 16).ok()).unwrap_or(0)
    }
}
