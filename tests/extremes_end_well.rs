//! Promise: extreme input ends in a sound state, or in an error that names the cause and changes nothing; it never ends
//! in a hang, a panic, or meaningless numbers without an error. The cases are those of `millpond check extremes`.
use millpond::Failure;
use millpond::extremes::{Case, End, Measure, coincident, inputs, judge, particles, settings};
use millpond_gpu::Mode;

mod support;
use support::device;

fn end_well(test: &str, cases: Result<Vec<Case>, Failure>) {
    let gpu = device(test, Mode::Strict);
    let mut faults = Vec::new();
    for case in cases.expect("built-in scenes") {
        let verdict = judge(&case, gpu.as_ref()).unwrap_or_else(|failure| panic!("{}: {failure}", case.name));
        faults.extend(verdict.faults.iter().map(|fault| format!("{}: {fault}", case.name)));
    }
    assert!(faults.is_empty(), "{test}:\n{}", faults.join("\n"));
}

#[test]
fn odd_particles() {
    end_well("extremes_end_well, particles", particles::cases());
}

#[test]
fn two_particles_at_one_place_under_every_choice() {
    end_well("extremes_end_well, coincident", coincident::cases());
}

#[test]
fn odd_scenes() {
    end_well("extremes_end_well, settings", settings::cases());
}

#[test]
fn every_number_of_a_scene_as_what_no_number_should_be() {
    end_well("extremes_end_well, inputs", inputs::cases());
}

#[test]
fn and_one_that_should_end_otherwise_is_found() {
    // the expected ends are swapped: a scene that is refused is expected to start and then stop with an error, and all
    // other cases are expected to be refused
    let mut wrong: Vec<Case> = particles::cases().expect("built-in scenes");
    for case in &mut wrong {
        case.end = match case.end {
            End::Refused(_) => End::Stopped(|_| true),
            _ => End::Refused(|_| true),
        };
    }
    for case in wrong.iter().filter(|case| !case.name.contains("10^4")) {
        let verdict = judge(case, None).expect("no device that could fail");
        assert!(!verdict.faults.is_empty(), "{}", case.name);
    }
}

#[test]
fn and_a_refusal_that_names_another_field_is_found() {
    let cases = inputs::cases().expect("built-in scenes");
    assert_eq!(cases.len(), 93 * 4, "every number of a scene");
    let mut refused = 0;
    for mut case in cases {
        // a field that does not exist, and one that exists and is valid
        let end = case.end;
        for other in ["nobodys_field", "grid.structure"] {
            case.end = match end {
                End::NotANumber(_) => End::NotANumber(other),
                _ => End::Naming([other; 2], Measure::Finite),
            };
            let verdict = judge(&case, None).expect("no device that could fail");
            let of_the_scene = verdict.result.starts_with("refused: ") && !verdict.result.contains("cannot start");
            assert_eq!(!verdict.faults.is_empty(), of_the_scene, "{}: {}", case.name, verdict.result);
            refused += u32::from(of_the_scene);
        }
    }
    assert!(refused >= 2 * (77 * 3 + 20), "{refused} refusals");
}
