//! Every format: written, read back, compared, damaged.

mod drawings;
mod dxf;
mod malformed;
mod models;
mod round_trip;
mod step;
