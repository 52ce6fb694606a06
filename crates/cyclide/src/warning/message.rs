//! What a warning says: plain sentences with the place, the measure, the limit and what helps.

use super::reason::as_noise;
use super::words::{rounded_down, times, write_nodes_not_reached, write_open_profile, write_relaxed};
use super::{SwingPart, Warning};
use crate::shape_change::degrees;
use crate::short_number::ShortNumber;

/// Points that scatter by more than this part of what counts as leaning are called noisy.
const SCATTER: f64 = 0.15;
/// Neighbouring chords that differ by this factor are no uneven spacing: the shorter one joins a point to itself.
const NEARLY_REPEATED: f64 = 1000.0;

/// Times the distance of corners from the plane beside them, a flatness with which faces of rounded points are in one plane: of a box of
/// points whose digits are cut, with 99 of 100.
const IN_ONE_PLANE: f64 = 4.0;

impl std::fmt::Display for Warning {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        match self {
            Self::Cusp { node } => {
                write!(f, "point {node}: the curve turns back on itself (cusp), joint only connected")
            }
            Self::SharpTurn { node, angle, limit } => {
                write!(
                    f,
                    "point {node}: the points turn back by {:.2} degrees (more than {:.0} is sharp): the circle through it and its neighbours is very large, and the curve swings out; if a corner is meant, mark it",
                    angle.to_degrees(),
                    limit.to_degrees()
                )
            }
            Self::SharpTurnCut { node, angle, limit } => {
                write!(
                    f,
                    "point {node}: the points turn back by {:.2} degrees (more than {:.0} is sharp): a smooth curve would swing out, so the point is made a corner",
                    angle.to_degrees(),
                    limit.to_degrees()
                )
            }
            Self::Relaxed { segments } => write_relaxed(f, segments),
            Self::LongWay { segment } => {
                write!(f, "segment {segment}: the blend takes the long way between its circles")
            }
            Self::OppositeCircles { segment } => {
                write!(
                    f,
                    "segment {segment}: its circles run in opposite directions, small changes move the curve a lot"
                )
            }
            Self::RoundedDirections { segment, count, angle, limit } => write!(
                f,
                "{count} chord(s), the first is segment {segment}, are so short for coordinates this large that rounding turns them by up to {} degrees (above {}): move the points to the origin before they are written, or merge them",
                degrees(*angle),
                degrees(*limit)
            ),
            Self::UnevenSpacing { node, ratio, .. } if *ratio >= NEARLY_REPEATED => {
                write!(
                    f,
                    "point {node}: neighbouring chords differ by a factor {ratio:.0}: two points nearly repeat each other there, and the curve may loop; remove one of them"
                )
            }
            Self::UnevenSpacing { node, ratio, limit } => {
                write!(
                    f,
                    "point {node}: neighbouring chords differ by a factor {ratio:.1} (above {limit}), the curve may bulge"
                )
            }
            Self::SpikeNearPoint { point, width, .. } => write!(
                f,
                "the curve reaches point {point} in a needle only, over {} of its parameter: the other points hardly leave it the way; \
                 change the parameters or take a Moebius spline",
                ShortNumber(*width)
            ),
            Self::LargeExcursion { reach, t, limit } => write!(
                f,
                "near the parameter {} the curve is {} times as far from the middle of its points as these are (above {} is said); change \
                 the parameters or take a Moebius spline",
                ShortNumber(*t),
                ShortNumber(*reach),
                ShortNumber(*limit)
            ),
            Self::TurnsBack { t, count, limit, .. } => write!(
                f,
                "in {count} place(s), the first near the parameter {}, the curve turns right back, on less than {} of the spacing of the points: they are nearly on \
                 a curve of lower degree, and it runs to and fro along that; change the parameters or take a Moebius spline",
                ShortNumber(*t),
                ShortNumber(*limit)
            ),
            Self::SpeedSpike { span, time, ratio, turning, remedy, .. } => write!(
                f,
                "span {span}: {} seconds from its start the body {} {} times as fast as on average over the span: the motion has a spike there; {}",
                ShortNumber(*time),
                if *turning { "turns" } else { "runs" },
                ShortNumber(*ratio),
                remedy.advice()
            ),
            Self::TurnsNearlyInPlace { span, turn, seconds, ratio, .. } => write!(
                f,
                "span {span}, from pose {span} to the next: the body turns by {} degrees within {} seconds, {} times as fast as on average, as its tool has hardly \
                 a way there, by which the law goes: give an `arm`, the length by which turns count as way, or a larger one",
                degrees(*turn),
                ShortNumber(*seconds),
                ShortNumber(*ratio)
            ),
            Self::RestsPassedOver { span, count } => write!(
                f,
                "in {count} span(s) the body rests, first from pose {span} to the next: a law that goes by the way has no time for that, and it does not stop there; \
                 go by the times of the poses (`as-given`), or make a motion of each part"
            ),
            Self::MotionReverses { span, time, count, velocity_jump } => write!(
                f,
                "in {count} place(s) the way of the tool turns back, first {} seconds from its start, on span {span}: a law that goes by the way keeps its speed \
                 there, and the velocity jumps by {}; go by times of the poses that fit the ways (`as-given`), or change the poses",
                ShortNumber(*time),
                ShortNumber(*velocity_jump)
            ),
            Self::MotionSwings { span, count, ratio, part, beyond, .. } => {
                let words = part.words();
                let unit = if *part == SwingPart::Turn { " rad" } else { "" };
                let beyond = ShortNumber(*beyond);
                write!(
                    f,
                    "in {count} span(s) the motion runs beyond its poses and back, most from pose {span} to the next, where {words} "
                )?;
                if ratio.is_finite() {
                    let ratio = ShortNumber(*ratio);
                    write!(f, "starts or ends {ratio} times as fast as it goes on average, and runs {beyond}{unit} beyond")?;
                } else {
                    write!(f, "goes on though it is the same at both, by {beyond}{unit}")?;
                }
                f.write_str(
                    ": the kind `linear` goes straight from pose to pose; or give times that fit the ways, or a pose more (the same pose twice is a rest)",
                )
            }
            Self::LeavesChords { span, count, distance, chord, .. } => write!(
                f,
                "in {count} span(s) the turns of the body carry its origin away from the straight line between the poses, most from pose {span} to the next, by {} \
                 on a distance of {}: the kind `linear` goes straight from pose to pose; or give poses in between",
                ShortNumber(*distance),
                ShortNumber(*chord)
            ),
            Self::PosesNoisier { turning, sigma, tolerance, needed } => {
                let (of, unit) = in_place_or_angle(*turning);
                let [sigma, tolerance] = [sigma, tolerance].map(|value| ShortNumber(*value));
                let needed = ShortNumber::no_less(*needed);
                write!(
                    f,
                    "the tolerance in {of} of {tolerance}{unit} is below what the noise of the poses makes of the farthest one: its standard deviation is about {sigma}{unit} in one \
                     direction, and single poses pull the motion to and fro; give {needed}{unit} or more"
                )
            }
            Self::PoseOutlier { pose, turning, distance, noise, dropped, count } => {
                let (of, unit) = in_place_or_angle(*turning);
                write!(
                    f,
                    "pose {pose} is an outlier in {of} ({count} in all): it is {}{unit} from where the poses around it go on, whose noise has a standard deviation of {}{unit}; {}",
                    ShortNumber(*distance),
                    ShortNumber(*noise),
                    if *dropped {
                        "left out"
                    } else {
                        "kept, and the motion follows it within the tolerance; `\"outliers\": \"drop\"` in the document leaves it out"
                    }
                )
            }
            Self::MotionSmoothedAway { turning, path, poses } => {
                let (of, unit) = in_place_or_angle(*turning);
                write!(
                    f,
                    "the path of the motion in {of} is {}{unit} long, its poses say {}{unit}: what is smaller than the tolerance is gone; give a smaller one",
                    ShortNumber(*path),
                    ShortNumber(*poses)
                )
            }
            Self::WideForMotion { turning, tolerance, extent } => {
                let (of, unit) = in_place_or_angle(*turning);
                write!(
                    f,
                    "the tolerance in {of} of {}{unit} is wide against the path, which gets {}{unit} away from its start: bends smaller than it may be gone",
                    ShortNumber(*tolerance),
                    ShortNumber(*extent)
                )
            }
            Self::BlendsShortened { pose, count, radius, asked } => write!(
                f,
                "the blends at {count} pose(s) are shorter than the radius of {}: they take half of the way to the next pose at most, at pose {pose} {}; give a smaller radius, \
                 or poses farther apart",
                ShortNumber(*asked),
                ShortNumber(*radius)
            ),
            Self::HalfTurn { pose, count, .. } => write!(
                f,
                "{count} pose(s), first pose {pose}, are turned by half a turn against the one before, up to rounding: both ways round are as short, and which one \
                 the body takes hangs on the sign or the last digit of what the pose is written with; give a pose in between"
            ),
            Self::PosesRounded { off, limit } => write!(
                f,
                "but for {} of their size the poses are planar, spherical, moved without a turn or of one motion of degree 2, and are taken for that (Study \
                 forms of up to {} count as rounded digits)",
                ShortNumber(*off),
                ShortNumber(*limit)
            ),
            Self::CuspInside { count, t, at: [x, y, z], angle } => write!(
                f,
                "the curve comes to a stand and turns by {} degrees in {count} place(s), the first is t = {}, point {}, {}, {} (cusp)",
                degrees(*angle),
                ShortNumber(*t),
                ShortNumber(*x),
                ShortNumber(*y),
                ShortNumber(*z)
            ),
            Self::CornerKept { vertex, count: 1, most, .. } => {
                write!(f, "point {vertex}: corner of {:.1} degrees kept", most.to_degrees())
            }
            Self::CornerKept { vertex, count, least, most } => {
                let (least, most) = (format!("{:.1}", least.to_degrees()), format!("{:.1}", most.to_degrees()));
                let range = if least == most { most } else { format!("{least} to {most}") };
                write!(f, "{count} corners of {range} degrees kept, the first at point {vertex}")
            }
            Self::SamplesTooCoarse { sagitta, limit } => write!(
                f,
                "median sagitta of the edges is {}, an arc over two of them allows {}: if the points are samples of a smooth curve, use the target `points`",
                ShortNumber(*sagitta),
                ShortNumber(*limit)
            ),
            Self::ToleranceBelowNoise { fraction } => {
                write!(
                    f,
                    "{:.0} % of the arcs span two edges or fewer: the tolerance is below the noise of the points, or they are too far apart for it",
                    fraction * 100.0
                )
            }
            Self::Wavers { curve, data, explained, remedy } => {
                write!(f, "the curve changes {} between left and right, its points {}", times(*curve), times(*data))?;
                if explained > data {
                    write!(f, " ({explained} with the ends of their straight runs)")?;
                }
                write!(f, ": it wavers between them (the comb of a picture shows where); {}", remedy.advice())
            }
            Self::CornerNotMarked { node, count, angle, distance } => write!(
                f,
                "{count} point(s) turn between straight runs, by up to {:.1} degrees, the first is point {node}: the curve goes round and leaves the runs by up to {}; if corners are meant, mark them (a corner angle)",
                angle.to_degrees(),
                ShortNumber(*distance)
            ),
            Self::DataWaver { changes, nodes } => write!(
                f,
                "the points change {changes} times between left and right at {nodes} nodes, as noise does, and the curve passes through all of them: a fit within a tolerance is smoother"
            ),
            Self::TightArc { piece, vertex, radius, data, limit, count } => {
                write!(
                    f,
                    "{count} arc(s) much tighter than the data, the tightest is piece {piece} at point {vertex}: radius {}, the tightest circle of the data there has {} (below {} is tight)",
                    ShortNumber(*radius),
                    ShortNumber(*data),
                    ShortNumber(*limit)
                )
            }
            Self::TurnsMoreThanData { turning, limit } => {
                write!(
                    f,
                    "the fit turns by {turning:.2} radians in all, its data by at most {limit:.2}: smooth the points or raise the tolerance"
                )
            }
            Self::ManyNodes { nodes, points, changes } => {
                write!(f, "{nodes} nodes for {points} points, ")?;
                if as_noise(*changes, *points) {
                    write!(
                        f,
                        "which change between left and right {changes} times, as noise does: the tolerance is below their noise"
                    )
                } else {
                    f.write_str("which are too few, or the tolerance too small, to be described by fewer; corners are followed with few nodes only if they are given (a corner angle)")
                }
            }
            Self::LeansOnWalls { rms, limit, scatter } => {
                write!(
                    f,
                    "the curve leans on the bounds of the tolerance, as the fairest one does: the root mean square of the distances is {} (more than {} is much); ",
                    ShortNumber(*rms),
                    ShortNumber(*limit)
                )?;
                match *scatter {
                    Some(scatter) if scatter > SCATTER * limit => write!(
                        f,
                        "the points scatter by {} from one to the next: if that is noise, `--smooth auto` (in a document `\"tolerance\": \"auto\"`) follows it and comes nearer to what was measured",
                        ShortNumber(scatter)
                    ),
                    Some(scatter) => write!(
                        f,
                        "the points scatter by no more than {} from one to the next: a smaller tolerance, or a centre of 1, comes nearer to them",
                        ShortNumber(scatter)
                    ),
                    None => f.write_str("a smaller tolerance, or a centre of 1, comes nearer to the points"),
                }
            }
            Self::BeyondNoise { rms, noise } => write!(
                f,
                "the curve leaves out more than noise: the root mean square of the distances is {}, and the noise of the points has a standard \
                 deviation of about {}, so the curve may be farther from what was measured than the points are; `--smooth auto` (in a document \
                 `\"tolerance\": \"auto\"`) follows the noise",
                ShortNumber(*rms),
                ShortNumber(*noise)
            ),
            Self::WideTolerance { tolerance, used } if used >= tolerance => write!(
                f,
                "the tolerance {} is wide against the figure: bends and corners smaller than it may be gone",
                ShortNumber(*tolerance)
            ),
            Self::WideTolerance { tolerance, used } => write!(
                f,
                "the tolerance {} is wide against the figure: the curve keeps within {}, where it is fairer or swings out less",
                ShortNumber(*tolerance),
                ShortNumber(*used)
            ),
            Self::ShapeSmoothedAway { curve, data } => write!(
                f,
                "the curve is {} long, its points say {}: bends or loops smaller than the tolerance are gone",
                ShortNumber(*curve),
                ShortNumber(*data)
            ),
            Self::NodesNotReached { asked, reached, why } => write_nodes_not_reached(f, *asked, *reached, why),
            Self::EndsWithoutEffect => f.write_str("a closed curve has no ends: what was asked for them has no effect"),
            Self::SwingsOut { distance, limit, held, has_target } => write!(
                f,
                "between the points the curve {} up to {} from their polyline (more than {} is far){}; {}",
                if *held { "would swing out" } else { "swings out" },
                ShortNumber(*distance),
                ShortNumber(*limit),
                if *held { ": it is held to places on the edges too" } else { "" },
                if *has_target {
                    "if the edges are meant, the target `polyline` keeps to all of them; points that scatter are smoothed first"
                } else {
                    "if the points have corners, give a corner angle"
                }
            ),
            Self::LongEdges { count, held, .. } => write!(
                f,
                "{count} {} far longer than those round {}: {}; if that is wrong, measure points there",
                if *count == 1 { "edge from here is" } else { "edges, the first from here, are" },
                if *count == 1 { "it" } else { "them" },
                if *held { "taken for straight sides, which the curve keeps to" } else { "taken for gaps, over which nothing holds the curve" }
            ),
            Self::NoiseContradicted { given, found } => write!(
                f,
                "the noise is given as {}, but the points scatter by {}: {}",
                ShortNumber(*given),
                ShortNumber(*found),
                if given < found {
                    "the curve follows their noise; let them say it themselves, or give heights that are less certain a noise of their own"
                } else {
                    "the curve may leave out bends that they show"
                }
            ),
            Self::FewForNoise { points, noise, apart } => write!(
                f,
                "{points} points, usually {} apart, are read as measured with a noise of {}; so few may as well be the corners of an outline: if they are, give a tolerance or \
                 a corner angle",
                ShortNumber(*apart),
                ShortNumber(*noise)
            ),
            Self::ReadAsCurve { count, turn, distance, has_target } => write!(
                f,
                "{count} points that turn by up to {:.1} degrees are read as samples of a curve, which leaves their polyline by {}: if its edges are meant, {}a smaller corner \
                 angle {}",
                turn.to_degrees(),
                ShortNumber(*distance),
                if *has_target { "the target `polyline` keeps to all of them, " } else { "" },
                if *has_target { "to those between larger turns" } else { "keeps the larger turns as corners" }
            ),
            Self::FeetNotMonotone { point, count } => write!(
                f,
                "point {point} lies behind the point before it, measured along the curve ({count} such points): the points are closer together than their noise, so only the distance from the curve to the polyline is bounded, not that from the polyline to the curve"
            ),
            Self::Outlier { point, distance, noise, dropped, count } => {
                write!(
                    f,
                    "point {point} is an outlier ({count} in all): it is {} from the curve of the others, whose noise has a standard deviation of {}; ",
                    ShortNumber(*distance),
                    ShortNumber(*noise)
                )?;
                f.write_str(if *dropped { "left out" } else { "kept; `--outliers drop` leaves it out (in a document `\"outliers\": \"drop\"`)" })
            }
            Self::StopMerged { first, last, count, at, radius } => write!(
                f,
                "points {first} to {last} are a stop: {count} points within {} of {},{},{}, where nothing moved; they count as one point",
                ShortNumber(*radius),
                ShortNumber(at[0]),
                ShortNumber(at[1]),
                ShortNumber(at[2])
            ),
            Self::PointsMerged { first, count, limit } => {
                let limit = ShortNumber(*limit);
                match count {
                    1 => write!(f, "point {first} repeats the one before it (closer than {limit}): left out"),
                    _ => write!(
                        f,
                        "{count} points repeat those before them (closer than {limit}): left out, the first is point {first}"
                    ),
                }
            }
            Self::ClosingPointMerged { index } => {
                write!(f, "point {index} repeats the first point of the closed curve: merged with it")
            }
            Self::UmbilicsSmoothed { count, turn } => write!(
                f,
                "{count} umbilic(s) were smoothed away, which turned the directions by {} degrees in the mean: a net over the grid \
                 leaves the surface there",
                degrees(*turn)
            ),
            Self::GridPieces { count, coverage } => write!(
                f,
                "{count} grid(s) beside umbilics or cuts cover {} % of the surface; they do not share borders",
                ShortNumber((1000.0 * coverage).round() / 10.0)
            ),
            Self::PartlyCovered { coverage, limit, rectangles, umbilics } => write!(
                f,
                "{} % of the surface is covered, less than {} %: {}",
                ShortNumber((1000.0 * coverage).round() / 10.0),
                ShortNumber(100.0 * limit),
                match (rectangles, umbilics) {
                    (true, _) => "a border in steps (`staircase`) and shorter edges cover more",
                    (_, 0) => "shorter edges cover more, and the border `cover` all of it",
                    _ => {
                        "other lengths of edges may cover more; umbilics `smooth` cover more and leave the surface around them; or model \
                         the parts around the umbilics as patches of their own"
                    }
                }
            ),
            Self::UmbilicsLeftOut { count, at: [x, y, z] } => write!(
                f,
                "{count} umbilic(s) are not in the mesh, the first at {}, {}, {}: near the border, or where coordinates are folded, it ends before them",
                ShortNumber(*x),
                ShortNumber(*y),
                ShortNumber(*z)
            ),
            Self::OffCurvatureLines { part, angle, .. } => write!(
                f,
                "on {} % of the surface (where its curvatures differ) the grid runs more than {} degrees off the lines of curvature: a net leaves the surface there",
                ShortNumber((1000.0 * part).round() / 10.0),
                degrees(*angle)
            ),
            Self::SpiralLines { shift, edge } => write!(
                f,
                "the lines of curvature are spirals, which come back {} higher or lower (an edge is {}): a closed net leaves the \
                 surface by about half of that",
                ShortNumber(*shift),
                ShortNumber(*edge)
            ),
            Self::UnevenEdges { piece, edges: [shortest, longest], limit } => write!(
                f,
                "edges of grid {piece} are {} to {} long, more than {} times apart: lines of curvature run together there",
                ShortNumber(*shortest),
                ShortNumber(*longest),
                ShortNumber(*limit)
            ),
            Self::AcrossCurvatureLines { angle, limit } => write!(
                f,
                "the grid lines run {} degrees off the curvature lines of the surface on average (more than {} is across them): quads with circles follow curvature lines",
                degrees(*angle),
                degrees(*limit)
            ),
            Self::ShapeChanged { change } => write!(f, "the shape changed: {}", change.changed()),
            Self::MovedFar { vertex, distance, limit } => {
                write!(
                    f,
                    "vertex {vertex} moved by {} (more than {} is far): align the grid with the curvature lines first",
                    ShortNumber(*distance),
                    ShortNumber(*limit)
                )
            }
            Self::LeftSurface { vertex, distance, limit } => {
                write!(
                    f,
                    "vertex {vertex} is {} off the input surface (more than {} is far)",
                    ShortNumber(*distance),
                    ShortNumber(*limit)
                )
            }
            Self::Zigzag { agreement, turn } => write!(
                f,
                "grid lines zigzag: neighbouring turns of {:.1} degrees on average agree by {agreement:.2}; smooth or refine the grid first",
                turn.to_degrees()
            ),
            Self::NeckFolds { radius, limit } => write!(
                f,
                "the neck runs through itself on the side to which the pipe leans: a ball of radius {} rolls through bends of radius {}; take a smaller ball",
                ShortNumber(*radius),
                ShortNumber(*limit)
            ),
            Self::FoldsBack { vertices: [from, to], triangle, angle, count } => write!(
                f,
                "the surface folds back at {count} edge(s), most of all at that between the vertices {from} and {to}, in triangle {triangle}: its normal turns by {:.0} degrees there; `crease_angle` keeps edges, a finer or smoother mesh has no folds",
                angle.to_degrees()
            ),
            Self::SharpEdgesSmoothed { vertices: [from, to], angle, count, limit } => write!(
                f,
                "{count} edge(s) that bend by more than {:.0} degrees are smoothed away, by up to {:.1} degrees, between the vertices {from} and {to}: `crease_angle` keeps them",
                limit.to_degrees(),
                angle.to_degrees()
            ),
            Self::LooseBorders { vertices: [from, to], count, borders, gap } => write!(
                f,
                "{count} of {borders} border edges lie within {} of another one, the first between the vertices {from} and {to}: points that are meant to be one are apart, weld them; or a vertex is inside an edge of a neighbour, cut this there",
                ShortNumber(*gap)
            ),
            Self::FlatnessRaised { asked, used } => write!(
                f,
                "the points are not in planes within {}, 1e-9 of their diameter: {} is taken, as of rounded points; give the rounding of the points as `flatness`",
                ShortNumber(*asked),
                ShortNumber(*used)
            ),
            Self::FlatnessLowered { asked, used } => write!(
                f,
                "faces in planes within {} make no convex body, which is hardly thicker there; within {} they do, and that was taken",
                ShortNumber(*asked),
                ShortNumber(*used)
            ),
            Self::ShortEdges { ends: [first, second], count, length, limit } => write!(
                f,
                "{count} edge(s) are not longer than {}, where points are one but for rounding, the shortest that between the points {first} and {second}, of length {}: make their ends one point, or take the hull, which does",
                ShortNumber(*limit),
                ShortNumber(*length)
            ),
            Self::ShallowEdges { ends: [first, second], count, angle, limit, off } => write!(
                f,
                "{count} edge(s) bend by less than {} radians, least of all that between the points {first} and {second}, by {}: where their faces are meant to be in one plane, give the rounding of the points as `flatness`, about {}; corners are up to {} off the plane beside them",
                ShortNumber(*limit),
                ShortNumber(*angle),
                ShortNumber(IN_ONE_PLANE * off),
                ShortNumber(*off)
            ),
            Self::EllipsesCross { along_x, along_y } => write!(
                f,
                "the ellipses cross: the second is wider by {} along x and by {} along y, and the bridge runs through itself beside the places where they do; take one inside the other",
                ShortNumber(*along_x),
                ShortNumber(*along_y)
            ),
            Self::MovedToAxis { distance, limit } => write!(
                f,
                "the profile ends up to {} off the axis (up to {} counts as meant to be on it): its ends were moved onto the axis; write more digits, or start farther out for a bore",
                ShortNumber(*distance),
                ShortNumber(*limit)
            ),
            Self::OpenPart { angle } => write!(
                f,
                "the body is open at both ends of its turn by {} degrees: end faces are made of contours in one plane with the axis that meet neither themselves nor each other; a whole turn is a solid",
                degrees(*angle)
            ),
            Self::OpenProfile { start, end } => write_open_profile(f, *start, *end),
            Self::Pinched { height } => write!(
                f,
                "the closed profile touches the axis at the height {}, and the solid is pinched there: all around it meets itself in one point, which many programs take for no solid; keep the profile off the axis, or run it along the axis",
                ShortNumber(*height)
            ),
            Self::NearlyFullArcs { piece, angle, limit } => write!(
                f,
                "the arcs of piece {piece} start {} radians from the way back along their chords (reported below {}): nearly full circles, ten chords and more in radius, off whose faces readers of files may find their edges; lean the tangent farther to a side",
                ShortNumber(*angle),
                ShortNumber(*limit)
            ),
            Self::SpheresNearlyOpposite { length, limit } => write!(
                f,
                "the spheres at the corners nearly oppose each other: where {} of the blended one is left (reported up to {limit}) the patch swings round, far out and within a small part of the triangle, and meshes of it need many triangles",
                ShortNumber(*length)
            ),
            Self::FlatRevolution => f.write_str(
                "the profile lies in a plane across the axis, and what it sweeps is flat; for a body give it heights along the axis (points [r, 0, z] for the axis z), or take an axis in its plane",
            ),
            Self::KinksAtJoints { count, joint, angle, limit } => write!(
                f,
                "the surface has kinks at {count} joint(s) where both curves run smoothly, the largest of {} degrees at joint {joint} (above {}): speeds jump there from piece to piece by different factors; take curves with pieces of like lengths on both sides, or of one piece",
                degrees(*angle),
                degrees(*limit)
            ),
            Self::OpenSeam { border, gap, angle } => write!(
                f,
                "the first and the last {border} of the grid are at most an edge apart and the net is open there: the surface has a gap of up to {} and an angle of up to {} degrees there",
                ShortNumber(*gap),
                degrees(*angle)
            ),
            Self::BeyondFocalSet { distance, radius, first, count } => write!(
                f,
                "the offset by {} goes beyond the focal set on {count} patch(es), the first is patch {first}: the surface bends towards that side with radii down to {}, and beyond them its lines run backwards; offsets by less do not",
                ShortNumber(*distance),
                ShortNumber(rounded_down(*radius))
            ),
            Self::SweptSurfaceFolds { count, face, borders: 0 } => write!(
                f,
                "the surface folds back in {count} face(s), the first is face {face}: there the curve comes to move along itself"
            ),
            Self::SweptSurfaceFolds { count, face, borders } => write!(
                f,
                "the surface folds back in {count} face(s), {borders} of them at the border to the face before, the first is face {face}: there the curve comes to \
                 move along itself or back, and the surface lies on itself"
            ),
            Self::FoldedNet { singular, first, creases, angle } => {
                if let Some(first) = first {
                    write!(f, "{singular} singular patch(es), the first is quad {first}")?;
                }
                let and = if first.is_some() && *creases > 0 { "; " } else { "" };
                if *creases > 0 {
                    write!(f, "{and}{creases} joint(s) with a crease of up to {:.1} degrees", angle.to_degrees())?;
                }
                f.write_str(": the frame does not suit the grid")
            }
            Self::NormalFacesBackward { triangle, vertex, count } => write!(
                f,
                "{count} normal(s) point to the back of a triangle beside them, first that of vertex {vertex} in triangle {triangle}: the surface folds over there; turn the normals or the triangles, or refine the mesh"
            ),
            Self::VolumeFolds { at: [s, t, u] } => write!(
                f,
                "the block folds near s = {}, t = {}, u = {}: its parameter lines run backwards there, and cells have a negative volume; take a frame nearer to its sides, or corners nearer to those of a box",
                ShortNumber(*s),
                ShortNumber(*t),
                ShortNumber(*u)
            ),
            Self::VolumeFoldUndecided { at: [s, t, u], depth } => write!(
                f,
                "whether the block folds near s = {}, t = {}, u = {} is not decided after {depth} quarterings: cells are flat there at best",
                ShortNumber(*s),
                ShortNumber(*t),
                ShortNumber(*u)
            ),
            Self::CellsInverted { count, cells, block, at: [i, j, k], cause } => write!(
                f,
                "{count} of {cells} cells are inverted, first cell {i}, {j}, {k} of block {block}: {}",
                cause.words()
            ),
        }
    }
}

/// What a tolerance of a motion is of, and the unit of an angle.
fn in_place_or_angle(turning: bool) -> (&'static str, &'static str) {
    if turning { ("angle", " rad") } else { ("place", "") }
}
