//! Test helpers of cyclide (unpublished).
