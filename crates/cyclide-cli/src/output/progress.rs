//! A progress bar on standard error, where a person can see it and when the work is long enough to ask.

use std::time::Duration;

use indicatif::{ProgressBar, ProgressDrawTarget, ProgressStyle};

/// The bar appears when the work has lasted this long.
const PATIENCE: Duration = Duration::from_millis(400);

/// Time between two pictures of the bar.
const TICK: Duration = Duration::from_millis(100);

/// Steps of a run; drawn only if standard error is a terminal.
pub struct Progress {
    bar: ProgressBar,
}

impl Progress {
    /// Progress over `steps` steps.
    pub fn new(steps: usize) -> Self {
        let bar = ProgressBar::with_draw_target(Some(steps as u64), ProgressDrawTarget::hidden());
        if let Ok(style) = ProgressStyle::with_template("{bar:24} {pos}/{len} {elapsed} {msg}") {
            bar.set_style(style);
        }
        let later = bar.clone();
        // Not waited for: a run that is done sooner ends without having shown the bar.
        std::thread::spawn(move || {
            std::thread::sleep(PATIENCE);
            if !later.is_finished() {
                later.set_draw_target(ProgressDrawTarget::stderr());
                later.enable_steady_tick(TICK);
            }
        });
        Self { bar }
    }

    /// Says what is being done now.
    pub fn doing(&self, what: String) {
        self.bar.set_message(cyclide_io::text::escaped(&what).into_owned());
    }

    /// One step is done.
    pub fn done(&self) {
        self.bar.inc(1);
    }

    /// Prints something without the bar in the way.
    pub fn suspended(&self, show: impl FnOnce()) {
        self.bar.suspend(show);
    }
}

impl Drop for Progress {
    fn drop(&mut self) {
        self.bar.finish_and_clear();
    }
}
