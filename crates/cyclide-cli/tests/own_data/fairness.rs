//! Runs that waver, and those that do not.
