//! Tables as surveyors, robots and spreadsheets write them.
