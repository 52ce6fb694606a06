//! Readers and writers of cyclide.
