//! Models of the gallery and others like them: a handle of twelve patches, a bent pipe, the faces of a cyclidic cube, an
//! inverted torus.

use crate::data::{PLACES, kink};
use crate::derived::layer;
use cyclide::{
    Point3, Vec3,
    conformal::{Conformal, Mobius},
    curve::Circle,
    surface::{CyclidePatch, CyclidicNet, DupinCyclide, NetFrame, PatchKind, QuadGrid},
};

/// Four rings of four vertices on circles of the radii 13, 9, 8.5 and 11.07, each the image of the last under an
/// inversion.
const HANDLE: [[f64; 3]; 16] = [
    [9.19238815542512, 9.192388155425117, 0.0],
    [-9.192388155425117, 9.19238815542512, 0.0],
    [-9.19238815542512, -9.192388155425117, 0.0],
    [9.192388155425116, -9.19238815542512, 0.0],
    [31.563780150876177, 6.773379508486247, 35.1816129362558],
    [27.228671771370642, 5.954432565990452, 47.092225319835805],
    [27.228671771370642, -5.954432565990451, 47.092225319835805],
    [31.563780150876177, -6.773379508486248, 35.1816129362558],
    [121.5908177660624, 28.605296951910304, 48.467529465298156],
    [122.43145854004138, 29.02859840091446, 60.44558088560703],
    [127.54357380459214, 19.055018698979268, 61.162617593646075],
    [127.42421653954693, 17.23193875588578, 49.32840472275592],
    [159.43093394187127, 49.507310219706646, 0.0],
    [173.14080410705202, 57.02511211246716, 0.0],
    [180.85796794054102, 44.00283498992669, 0.0],
    [167.65934644973152, 35.59144609380825, 0.0],
];

#[test]
fn a_handle_of_twelve_patches_of_cyclides() {
    let points = HANDLE.map(Point3::from);
    let grid = QuadGrid::new(points.to_vec(), [4, 4], [true, false]).unwrap();
    let r = std::f64::consts::FRAC_1_SQRT_2;
    // At the foot the surface narrows by 16°.
    let (sin, cos) = 16.0_f64.to_radians().sin_cos();
    let frame = NetFrame::First(Vec3::new(-r, r, 0.0), Vec3::new(-r * sin, -r * sin, cos));
    let net = CyclidicNet::new(grid, frame).unwrap();
    assert!(net.singular_patches().is_empty() && net.flipped_patches().is_empty() && kink(&net) < 1e-12);
    for patch in net.patches() {
        assert_eq!(patch.recognize(), PatchKind::Cyclide);
        assert!(patch.real_weights().into_iter().flatten().all(|w| w > 0.0));
    }
    for j in 0..3 {
        let [ring, next] = [4 * j, 4 * j + 4].map(|k| &points[k..k + 4]);
        // The line through a vertex and its image goes through the center, and the distances from it have one product.
        let [p, q] = [0, 2].map(|k| next[k] - ring[k]);
        let (normal, between) = (p.cross(q), ring[2] - ring[0]);
        let centre = ring[0] + p * (between.cross(q).dot(normal) / normal.length_squared());
        let power = (ring[0] - centre).dot(next[0] - centre);
        let inversion = Mobius::inversion(centre, power.sqrt()).unwrap();
        for (from, to) in ring.iter().zip(next) {
            // The center is where lines meet at a small angle: rounding of 1e-14 over that.
            assert!(inversion.map_point(*from).unwrap().distance(*to) < 1e-11);
        }
        // All sides of a ring are parts of its circle.
        let radius = Circle::through_points([ring[0], ring[1], ring[2]]).unwrap().radius();
        for i in 0..4 {
            assert!((net.patch(i, j).s_line(0.0).unwrap().radius().unwrap() - radius).abs() < 1e-12);
        }
    }
    // The grip swells between its ends, and both feet widen.
    let radii = |j: usize| PLACES.map(|t| net.patch(0, j).s_line(t).unwrap().radius().unwrap());
    let ([a, _, b, _, c], [foot, ..], [.., end]) = (radii(1), radii(0), radii(2));
    assert!(b > 1.2 * a && b > 1.2 * c && foot > a && end > c, "{a} {b} {c}, {foot} {end}");
    let body = net.thick(-2.0).unwrap();
    assert!(body.is_solid());
    let outer = &body.outer;
    assert_eq!((outer.faces().len(), outer.edges().len(), outer.vertices().len()), (32, 64, 32));
    let want = layer(&net, -2.0);
    // Gauss rules of 20 × 20 points per patch.
    assert!((outer.volume() - want).abs() < 1e-9 * want, "{} {want}", outer.volume());
}

/// Four vertices of a circle of radius 10, carried along by three turns: 80° at radius 30, 75° at 24 (in a plane turned
/// by 70°), 85° at 34 (turned by -35°).
const PIPE: [[f64; 3]; 16] = [
    [7.071067811865476, 7.071067811865475, 0.0],
    [-7.071067811865475, 7.071067811865476, 0.0],
    [-7.071067811865477, -7.071067811865475, 0.0],
    [7.071067811865474, -7.071067811865477, 0.0],
    [26.018432709681814, 7.071067811865476, 22.580590187166052],
    [23.56267663030236, 7.071067811865476, 36.50787499356643],
    [23.56267663030236, -7.071067811865476, 36.50787499356643],
    [26.018432709681814, -7.071067811865477, 22.580590187166052],
    [40.88471589517609, 17.474369303037754, 21.35701219099713],
    [43.24298066594306, 20.84318110784244, 34.888076239872525],
    [56.46939424850407, 15.956779848204544, 33.79946865545341],
    [54.11112947773711, 12.587968043399854, 20.268404606578017],
    [62.69670187388533, 35.06396761999741, -12.038581188330088],
    [72.88679215792001, 44.74851174745087, -10.498560069439506],
    [80.62930247814784, 35.43978710617959, -3.190949003287012],
    [70.43921219411315, 25.75524297872613, -4.730970122177587],
];

#[test]
fn a_pipe_of_twelve_patches_of_tori() {
    let grid = QuadGrid::new(PIPE.map(Point3::from).to_vec(), [4, 4], [true, false]).unwrap();
    let r = std::f64::consts::FRAC_1_SQRT_2;
    let own = NetFrame::First(Vec3::new(-r, r, 0.0), Vec3::Z);
    let net = CyclidicNet::new(grid, own).unwrap();
    assert!(net.singular_patches().is_empty() && kink(&net) < 1e-12);
    // With the frame of its first circle every row is a part of a torus.
    for (j, radius) in [(0, 30.0), (1, 24.0), (2, 34.0)] {
        for i in 0..4 {
            let patch = net.patch(i, j);
            let circle = patch.s_line(0.5).unwrap();
            assert!((circle.radius().unwrap() - 10.0).abs() < 1e-11);
            let k: Vec<f64> = PLACES.iter().map(|&s| patch.k2(s)).collect();
            // Curvature of the long circles where they are longest and shortest: between -1/(R-r) and 1/(R+r).
            assert!(
                k.iter().all(|k| *k > -1.0 / (radius + 10.0) - 1e-12 && *k < 1.0 / (radius - 10.0) + 1e-12),
                "{k:?}"
            );
        }
    }
    let shell = net.to_shell().unwrap();
    assert_eq!((shell.vertices().len(), shell.edges().len(), shell.faces().len()), (16, 28, 12));
    let body = net.thick(-2.0).unwrap();
    assert!(body.is_solid());
    // A pipe of section pi (10² - 8²), by Pappus along the centers.
    let length: f64 = [(30.0, 80.0_f64), (24.0, 75.0), (34.0, 85.0)].map(|(r, a)| r * a.to_radians()).iter().sum();
    let want = std::f64::consts::PI * 36.0 * length;
    assert!((body.outer.volume() - want).abs() < 1e-9 * want, "{} {want}", body.outer.volume());
    // Inverted, its three parts are three different cyclides, still smoothly joined.
    let image = net.transformed(&Mobius::inversion(Point3::new(36.0, -60.0, -40.0), 60.0).unwrap()).unwrap();
    assert!(image.singular_patches().is_empty() && kink(&image) < 1e-12);
    let radii: Vec<f64> = (0..3).map(|j| image.patch(0, j).s_line(0.0).unwrap().radius().unwrap()).collect();
    assert!(radii.windows(2).all(|r| (r[0] - r[1]).abs() > 0.1), "{radii:?}");
}

/// Vertices of a spherical cube, index bits s, t, u: all six faces concircular and embedded.
const CUBE: [[f64; 3]; 8] = [
    [0.0, 0.0, 0.0],
    [1.0, 0.18, -0.12],
    [-0.2, 1.0, 0.1],
    [0.8978130949642749, 1.1605620186487662, -0.03445510973722365],
    [0.12, -0.15, 0.9],
    [1.0024216235619485, -0.018012269921966886, 0.9371744371186895],
    [-0.05018219677251432, 0.7975013014055179, 1.1911504424778763],
    [0.9025599400908, 0.9071629228792054, 1.2212168873027933],
];

/// The frame at vertex 0.
const CUBE_FRAME: [[f64; 3]; 3] = [
    [0.9031523071646282, 0.42539206247377387, -0.057943966446202366],
    [-0.3467261660306035, 0.8023177931395692, 0.4858673940504445],
    [0.25317360812874634, -0.41872156858222714, 0.8721097248346168],
];

#[test]
fn the_faces_of_a_cyclidic_cube_meet_at_right_angles() {
    let (a, v) = (CUBE.map(Point3::from), CUBE_FRAME.map(Vec3::from));
    // The faces through vertex 0 and those opposite; there the frame is that of vertex 0, reflected.
    let face = |first: usize, [d, e]: [usize; 2]| {
        let corners = [first, first | 1 << d, first | 1 << e, first | 1 << d | 1 << e].map(|k| a[k]);
        let carried = |x: Vec3| {
            if first == 0 {
                return x;
            }
            let d = (a[first] - a[0]).unit().unwrap();
            x - d * (2.0 * d.dot(x))
        };
        CyclidePatch::from_corners_and_frame(corners, carried(v[d]), carried(v[e])).unwrap()
    };
    let faces = [[0, 1], [0, 2], [1, 2]].map(|pair| {
        let third = 3 - pair[0] - pair[1];
        [face(0, pair), face(1 << third, pair)]
    });
    for patch in faces.iter().flatten() {
        assert!(patch.is_regular() && patch.real_weights().into_iter().flatten().all(|w| w > 0.0));
    }
    // Faces st and su have the s-edges in common: at t, u = 0 or 1.
    for (j, k) in [(0, 0), (0, 1), (1, 0), (1, 1)] {
        let (st, su) = (&faces[0][k], &faces[1][j]);
        let (x, y) = (st.s_line(j as f64).unwrap(), su.s_line(k as f64).unwrap());
        assert!((x.bulge_vector() - y.bulge_vector()).length() < 1e-12, "the same arc");
        // Normals along a common line of curvature keep their angle.
        for s in [0.0, 1.0] {
            let cosine = st.unit_normal(s, j as f64).dot(su.unit_normal(s, k as f64));
            assert!(cosine.abs() < 1e-12);
        }
    }
}

#[test]
fn an_inverted_torus_is_a_closed_ring() {
    let torus = DupinCyclide::new(30.0, 0.0, 10.0).unwrap().nets([4, 4]).unwrap().remove(0);
    let image = torus.transformed(&Mobius::inversion(Point3::new(12.0, 0.0, 20.0), 25.0).unwrap()).unwrap();
    let shell = image.to_shell().unwrap();
    assert!(shell.is_closed() && shell.volume() > 0.0);
    assert!(kink(&image) < 1e-12 && image.singular_patches().is_empty());
}
