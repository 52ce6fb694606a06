//! Tees: balls, contacts, envelopes and bodies against what defines them.

use cyclide::{PipeTee, TeeBlend, TeeBranch, TeeMain};
use std::f64::consts::PI;

#[test]
fn an_upright_tee_of_one_quartic_is_a_solid() {
    let main = TeeMain { radius: 3.0, ends: [-12.0, 12.0] };
    let branch = TeeBranch { blend: TeeBlend::Least(0.5), ..TeeBranch::upright(2.0, 10.0, 0.5) };
    let made = PipeTee::new(main, vec![branch]).and_then(|tee| tee.made()).expect("a tee");
    assert!(made.body.is_solid());
    let volume = made.body.outer.volume();
    println!("{:?} {volume} faces {}", made.blends, made.body.outer.faces().len());
    // Both pipes, less than what is left of the branch within the main pipe, and a little more for the blend.
    let pipes = PI * 9.0 * 24.0 + PI * 4.0 * (10.0 - 3.0);
    assert!(volume > pipes && volume < pipes * 1.05, "{volume} {pipes}");
}
