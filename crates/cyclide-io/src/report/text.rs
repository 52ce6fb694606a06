//! The report as text for people: aligned, few digits, units behind the numbers.

use std::fmt;

use super::figures::{Line, measure, plural, range, short};
use super::{
    CurvesReport, FairnessReport, FileReport, FitPieces, GeometryReport, ObjectReport, PatchPlace, Report, ShapeReport,
    SurfaceReport,
};

impl fmt::Display for Report {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        for (i, (name, object)) in self.objects.iter().enumerate() {
            if i > 0 {
                writeln!(f)?;
            }
            object.write(f, name, self.units)?;
        }
        if self.files.is_empty() {
            return Ok(());
        }
        writeln!(f, "\nfiles")?;
        let rows: Vec<[String; 5]> = self.files.iter().map(|file| file.row(self.units)).collect();
        let width = |column: usize| rows.iter().map(|r| r[column].chars().count()).max().unwrap_or(0);
        let widths: Vec<usize> = (0..5).map(width).collect();
        for (row, file) in rows.iter().zip(&self.files) {
            let cells = row.iter().zip(&widths).map(|(cell, &width)| format!("{cell:width$}"));
            writeln!(f, "  {}", cells.collect::<Vec<_>>().join("  ").trim_end())?;
            for note in &file.notes {
                writeln!(f, "    note: {note}")?;
            }
        }
        Ok(())
    }
}

impl ObjectReport {
    fn write(&self, f: &mut fmt::Formatter<'_>, name: &str, units: &str) -> fmt::Result {
        let mut facts = vec![self.r#type.clone()];
        match &self.geometry {
            GeometryReport::Curves(curves) => curves.facts(&mut facts),
            GeometryReport::Surface(surface) => surface.facts(&mut facts),
            GeometryReport::Smooth(surface) => surface.facts(&mut facts),
            GeometryReport::Volume(volume) => volume.facts(&mut facts),
            GeometryReport::Motion(motion) => motion.facts(&mut facts),
        }
        if self.construction {
            facts.push("construction".to_owned());
        }
        writeln!(f, "{name}: {}", facts.join(", "))?;
        let mut line = |label: &str, text: String| writeln!(f, "  {label:<11}{text}");
        match &self.geometry {
            GeometryReport::Curves(curves) => curves.lines(units, &mut line)?,
            GeometryReport::Surface(surface) => surface.lines(units, &mut line)?,
            GeometryReport::Smooth(surface) => surface.lines(units, &mut line)?,
            GeometryReport::Volume(volume) => volume.lines(units, &mut line)?,
            GeometryReport::Motion(motion) => motion.lines(units, &mut line)?,
        }
        if !self.warnings.is_empty() {
            line("warnings", self.warnings.len().to_string())?;
        }
        Ok(())
    }
}

/// Tight places that the text names.
const MOST_TIGHT_PLACES: usize = 20;

impl CurvesReport {
    fn facts(&self, facts: &mut Vec<String>) {
        facts.push(if self.closed { "closed" } else { "open" }.to_owned());
        if self.contours != 1 {
            facts.push(plural(self.contours, "contour"));
        }
        if self.points > 0 {
            facts.push(plural(self.points, "point"));
        }
        facts.push(plural(self.pieces, "piece"));
        if let Some(principal) = &self.principal {
            // A grid that is continued past the border is larger than the surface.
            facts.push(match principal.border {
                "cover" => "the whole surface covered".to_owned(),
                _ => format!("{} % of the surface covered", short((1000.0 * principal.coverage).round() / 10.0)),
            });
        }
    }

    fn lines(&self, units: &str, line: Line<'_>) -> fmt::Result {
        line("length", format!("{} {units}", short(self.length)))?;
        let j = &self.joints;
        let smooth = j.count - j.corners;
        if smooth > 0 {
            let (angle, jump) = (short(j.smooth_angle), short(j.smooth_curvature_jump));
            let text =
                format!("{smooth}: gap {} {units}, angle {angle} rad, curvature jump {jump} 1/{units}", short(j.gap));
            line("joints", text)?;
        }
        if j.corners > 0 {
            line("corners", format!("{}: angle up to {} rad", j.corners, short(j.angle)))?;
        }
        let c = &self.curvature;
        let mut text = format!("up to {} 1/{units}", short(c.max));
        if c.max > 0.0 {
            let place = c.point.map(short).join(", ");
            text += &format!(
                " (radius {} {units}) at t = {}, station {} {units}, point {place}",
                short(1.0 / c.max),
                short(c.t),
                short(c.station)
            );
            if self.contours > 1 {
                text += &format!(" of contour {}", c.contour);
            }
        }
        line("curvature", text)?;
        if let Some(tight) = &self.tight {
            let (count, radius) = (tight.places.len(), short(tight.radius));
            let many = if count == 0 { "no place".to_owned() } else { plural(count, "place") };
            line("tight", format!("{many} with a radius below {radius} {units}"))?;
            for place in tight.places.iter().take(MOST_TIGHT_PLACES) {
                line("", place.words(units))?;
            }
            if count > MOST_TIGHT_PLACES {
                line("", format!("and {} more (--json has all)", count - MOST_TIGHT_PLACES))?;
            }
        }
        line("fairness", self.fairness.text())?;
        match &self.weights {
            Some(weights) => line("weights", range(weights))?,
            None => line("weights", "no rational form within the tolerance".to_owned())?,
        }
        if let Some(within) = self.within {
            line("accuracy", format!("within {} {units} of the true curve", short(within)))?;
        }
        if let Some(qb) = &self.qb {
            qb.lines(line)?;
        }
        if let Some(torus) = &self.torus {
            torus.lines(units, line)?;
        }
        if let Some(unrolled) = &self.unrolled {
            unrolled.lines(units, line)?;
        }
        if let Some(principal) = &self.principal {
            principal.lines(units, line)?;
        }
        if let Some(fit) = &self.fit {
            let made = match fit.made {
                FitPieces::Arcs { arcs, lines, .. } => format!("{} and {}", plural(arcs, "arc"), plural(lines, "line")),
                FitPieces::Fair { nodes, .. } => plural(nodes, "node"),
            };
            let deviation = short(fit.deviation);
            let mut known: Vec<String> = Vec::new();
            known.extend(fit.tolerance.map(|t| format!("tolerance {} {units}", short(t))));
            if let FitPieces::Fair { rms, noise, noise_z, deviation_z, .. } = fit.made {
                let of = |word: &str, x: Option<f64>| x.map(|x| format!("{word} {} {units}", short(x)));
                known.extend(of("root mean square", noise.map(|_| rms)));
                known.extend(of("noise", noise));
                known.extend(of("noise in z", noise_z));
                known.extend(of("deviation in z", deviation_z));
            }
            let known = if known.is_empty() { String::new() } else { format!(" ({})", known.join(", ")) };
            let polyline = short(fit.polyline_deviation);
            // One way only where points and curve do not advance together.
            let from = if fit.monotone { "from the polyline" } else { "from the curve to the polyline only" };
            line("fit", format!("{made}: deviation {deviation} {units}{known}, {polyline} {units} {from}"))?;
        }
        Ok(())
    }
}

impl FairnessReport {
    fn text(&self) -> String {
        let mut parts = Vec::new();
        parts.extend(self.sign_changes.map(|n| plural(n, "sign change")));
        parts.push(if self.extrema == 1 { "1 extremum".to_owned() } else { format!("{} extrema", self.extrema) });
        parts.push(match (self.variation, self.no_variation) {
            (Some(variation), _) => format!("variation {}", short(variation)),
            (None, Some("cusp")) => "no finite variation (cusp)".to_owned(),
            (None, _) => format!("no finite variation (the curvature jumps at {})", plural(self.jumps, "joint")),
        });
        parts.join(", ")
    }
}

impl SurfaceReport {
    fn facts(&self, facts: &mut Vec<String>) {
        let state = match (self.volume, self.closed) {
            (Some(_), _) => "solid",
            (None, true) => "closed",
            (None, false) => "open",
        };
        facts.push(state.to_owned());
        if self.bodies != 1 {
            facts.push(if self.bodies == 0 { "no body".to_owned() } else { format!("{} bodies", self.bodies) });
        }
        facts.push(if self.patches == 1 { "1 patch".to_owned() } else { format!("{} patches", self.patches) });
    }

    fn lines(&self, units: &str, line: Line<'_>) -> fmt::Result {
        if let Some(area) = self.area {
            line("area", measure(area, units, "²"))?;
        } else if !self.parts.is_empty() {
            let each = self.parts.iter().map(|part| measure(part.area, units, "²"));
            let together = measure(self.total_area, units, "²");
            line("areas", format!("{}; together {together}", listed(self.parts.len(), each)))?;
        }
        if let Some(volume) = self.volume {
            line("volume", measure(volume, units, "³"))?;
        }
        for reason in &self.not_known {
            line("not known", reason.clone())?;
        }
        let j = &self.joints;
        let (smooth, gap) = (j.count - j.creases, short(j.gap));
        if smooth > 0 {
            line("joints", format!("{smooth} smooth: gap {gap} {units}, angle {} rad", short(j.angle)))?;
        }
        if j.creases > 0 {
            let gap = if smooth > 0 { String::new() } else { format!("gap {gap} {units}, ") };
            line("creases", format!("{}: {gap}angle up to {} rad", j.creases, short(j.crease_angle)))?;
        }
        for seam in &self.seams {
            let (border, gap, angle) = (seam.border, short(seam.gap), short(seam.angle));
            line("open seam", format!("first and last {border}: gap {gap} {units}, angle {angle} rad"))?;
        }
        let (s, t) = (self.curvature_s.text(units), self.curvature_t.text(units));
        line("curvature", format!("along s {s}; along t {t}"))?;
        line("weights", range(&self.weights))?;
        if let (Some(residual), Some(cosine)) = (self.residual.map(short), self.orthogonality.map(short)) {
            line("accuracy", format!("in space to {residual} {units}, lines orthogonal to {cosine} rad"))?;
        }
        if let Some(polyhedron) = &self.polyhedron {
            line("polyhedron", polyhedron.text(units))?;
        }
        for tube in &self.tubes {
            line("tube", tube.text(units))?;
        }
        for (index, blend) in self.blends.iter().enumerate() {
            let of = if self.blends.len() > 1 { format!("of branch {index}: ") } else { String::new() };
            line("blend", format!("{of}{}", blend.text(units)))?;
        }
        if let Some(c) = &self.circular {
            let [most, mean, off] = [c.move_max, c.move_mean, c.off_surface_max].map(short);
            let moved = format!("vertices moved up to {most} {units}, {mean} {units} on average");
            let steps = plural(c.steps, "step");
            line("circular", format!("{moved}, and up to {off} {units} off the surface, in {steps}"))?;
            if let (Some(before), Some(after)) = (c.angle_before, c.angle_after) {
                let (before, after) = (short(before), short(after));
                line("", format!("angle to the curvature lines {after} rad (median), before {before} rad"))?;
            }
            for closing in &c.closing {
                let [before, after, stretch] =
                    [closing.angle_before, closing.angle_after, closing.stretch_after].map(short);
                let frame = format!("along {}: after one turn the frame is rotated by {after} rad", closing.direction);
                line("closing", format!("{frame}, before by {before} rad; speeds agree to {stretch}"))?;
            }
            if let Some(round) = &c.round {
                let [before, after] = [round.angle_before, round.angle_after].map(short);
                let vertices = match round.vertices {
                    1 => "one extraordinary vertex".to_owned(),
                    count => format!("{count} extraordinary vertices"),
                };
                line(
                    "openings",
                    format!("around {vertices} the frame is rotated by {after} rad, before by {before} rad"),
                )?;
            }
            if let Some(shape) = &c.shape {
                line("shape", shape.to_string())?;
            }
        }
        if !self.singular.is_empty() {
            let places = self.singular.iter().map(|p| (p.place, [('s', &p.s), ('t', &p.t)]));
            let texts = places.map(|(place, lists)| {
                let lists = lists.iter().filter(|(_, list)| !list.is_empty());
                let lists = lists.map(|(name, list)| {
                    format!("{name} = {}", list.iter().map(|v| short(*v)).collect::<Vec<_>>().join(", "))
                });
                format!("{} at {}", self.place(place), lists.collect::<Vec<_>>().join(", "))
            });
            line("singular", listed(self.singular.len(), texts))?;
        }
        if !self.flipped.is_empty() {
            line("flipped", listed(self.flipped.len(), self.flipped.iter().map(|place| self.place(*place))))?;
        }
        Ok(())
    }

    /// A patch as the text names it: counted from 0, with its body where there are several.
    fn place(&self, place: PatchPlace) -> String {
        if self.bodies > 1 {
            format!("patch {} of body {}", place.patch, place.body)
        } else {
            format!("patch {}", place.patch)
        }
    }
}

impl fmt::Display for ShapeReport {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let percent = |part: f64| format!("{:.0} %", 100.0 * part);
        for (part, of) in [(self.bending, "bending"), (self.thickness, "thickness")] {
            if let Some(part) = part {
                write!(f, "{} of the {of}, ", percent(part))?;
            }
        }
        write!(f, "normals turned by {} rad rms", short(self.turn))?;
        if let Some(turn) = self.normal_turn {
            write!(f, " ({} of their spread)", percent(turn))?;
        }
        write!(f, ", humps or ripples lost on {} of the surface", percent(self.lost_relief))
    }
}

/// Items of a list named in the text; the JSON report holds them all.
const SHOWN: usize = 3;

/// A count and the first few items.
fn listed(count: usize, items: impl Iterator<Item = String>) -> String {
    let shown = items.take(SHOWN).collect::<Vec<_>>().join("; ");
    let more = if count > SHOWN { format!("; {} more", count - SHOWN) } else { String::new() };
    format!("{count}: {shown}{more}")
}

impl FileReport {
    fn row(&self, units: &str) -> [String; 5] {
        let kept = if self.exact {
            "exact".to_owned()
        } else {
            format!("within {} {units}, {}", short(self.bound), self.proof)
        };
        let deviation = match self.deviation {
            Some(d) => format!("deviation {} {units}", short(d)),
            None => String::new(),
        };
        let kept = match (self.deviation, self.exact) {
            (None, true) => "index of the other files".to_owned(),
            (None, false) => "picture".to_owned(),
            _ => kept,
        };
        [self.path.clone(), self.format.to_owned(), kept, deviation, size_text(self.bytes)]
    }
}

fn size_text(bytes: usize) -> String {
    if bytes < 10_000 { format!("{bytes} bytes") } else { format!("{:.0} kB", bytes as f64 / 1000.0) }
}
