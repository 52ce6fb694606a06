//! One face in STEP for each surface of a body.
