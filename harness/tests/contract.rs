//! Promise: the interface of the program. The exit status is 0, 1, 2, 3 or 4. With `--json` stdout is one document and
//! nothing else, and it has the keys that other programs rely on. An error in the input names file, line and field, and
//! nothing is written.
use serde_json::Value;
use std::path::Path;
use std::process::{Command, Output};

fn millpond(folder: &Path, arguments: &[&str]) -> Output {
    let mut command = Command::new(env!("CARGO_BIN_EXE_millpond"));
    command.current_dir(folder).args(arguments).output().expect("it runs")
}

/// Returns the JSON document of a call that must succeed.
fn json(arguments: &[&str]) -> Value {
    let folder = tempfile::tempdir().expect("a folder");
    let output = millpond(folder.path(), arguments);
    let (out, err) = (String::from_utf8_lossy(&output.stdout), String::from_utf8_lossy(&output.stderr));
    assert_eq!(output.status.code(), Some(0), "{arguments:?}: {err}");
    serde_json::from_str(&out).unwrap_or_else(|e| panic!("{arguments:?}: {e}: {out}"))
}

/// Asserts that a document has these keys; `a.b` is a key of an object, and `a[].b` a key of all items of a list.
fn has(document: &Value, keys: &[&str]) {
    for key in keys {
        let mut at = vec![document];
        for part in key.split('.') {
            let (name, list) = part.strip_suffix("[]").map_or((part, false), |name| (name, true));
            at = at.into_iter().map(|v| v.get(name).unwrap_or_else(|| panic!("no {key}: {document}"))).collect();
            if list {
                at = at.into_iter().flat_map(|v| v.as_array().expect("a list")).collect();
                assert!(!at.is_empty(), "{key} is empty");
            }
        }
    }
}

#[test]
fn documents_have_the_keys_that_others_rely_on() {
    let run = json(&["run", "dam-break-2d", "--steps", "20", "--json"]);
    has(
        &run,
        &["scene", "backend", "particles", "steps", "simulated_s", "wall_s", "ms_per_step.min", "ms_per_step.median"],
    );
    has(&run, &["average_neighbours.first", "average_neighbours.last", "density_error.mean", "density_error.max"]);
    has(&run, &["hash", "warnings"]);
    assert_eq!((run["steps"].as_u64(), run["particles"].as_u64()), (Some(20), Some(3200)));

    let compare = json(&["compare", "thesis-cube", "--particles", "200", "--steps", "5", "--backend", "cpu", "--json"]);
    has(&compare, &["scene", "steps", "pairs[].a", "pairs[].b", "pairs[].bit_equal", "pairs[].first_divergent_step"]);
    has(&compare, &["pairs[].max_ulp.position", "pairs[].max_ulp.velocity", "pairs[].max_abs.position"]);
    has(&compare, &["pairs[].max_abs.velocity", "pairs[].within_tolerance"]);

    let bench = json(&["bench", "thesis-cube", "--particles", "200", "--steps", "3", "--json"]);
    has(&bench, &["scene", "particles", "threads", "simd", "ms_per_step.min", "ms_per_step.median", "passes[].name"]);
    has(&bench, &["passes[].ms", "ns_per_particle_step", "bytes_per_particle", "average_neighbours.first"]);
    has(&bench, &["average_neighbours.last", "real_time_factor"]);
    let bench = json(&["bench", "thesis-cube", "--particles", "200", "--steps", "3", "--structures", "--json"]);
    let roofs = ["bench", "thesis-cube", "--particles", "200", "--steps", "3", "--roofline", "--levels", "--json"];
    let roofs = json(&roofs);
    has(
        &roofs,
        &["ceilings.gigaoperations_per_second", "ceilings.gigabytes_per_second", "passes[].roof", "arrays[].bytes"],
    );
    has(&roofs, &["levels[].simd", "levels[].threads", "levels[].ms_per_step.min"]);
    has(&bench, &["structures[].structure", "structures[].ms_per_step.min", "structures[].bytes_per_particle"]);

    let own = env!("CARGO_BIN_EXE_millpond");
    let against =
        ["bench", "thesis-cube", "--particles", "200", "--steps", "3", "--rounds", "2", "--against", own, "--json"];
    let against = json(&against);
    has(&against, &["this[]", "other[]", "ratio"]);
    assert_eq!(against["this"].as_array().map(Vec::len), Some(2));

    let plan = json(&["plan", "dam-break", "--steps", "2", "--json"]);
    has(&plan, &["commands[]", "particles"]);
    has(
        &plan,
        &["passes[].name", "passes[].terms", "left_out[].what", "left_out[].why", "bytes.used", "bytes.everything"],
    );
    has(&plan, &["ms_per_step.plan", "ms_per_step.everything", "arrays[].name", "arrays[].bytes"]);
    let left_out = plan["left_out"].to_string();
    for what in ["surface tension", "elasticity", "bodies", "near pressure"] {
        assert!(left_out.contains(what), "{what}: {left_out}");
    }

    let error = json(&["error", "still-tank", "--quick", "--time", "0.02", "--json"]);
    has(&error, &["case", "runs[].label", "runs[].choice", "runs[].particles", "runs[].dt", "runs[].wall_s"]);
    has(&error, &["runs[].error", "pareto", "reference"]);
    let labels: Vec<&Value> = error["runs"].as_array().expect("a list").iter().map(|run| &run["label"]).collect();
    let front = error["pareto"].as_array().expect("a list");
    assert!(labels.len() >= 12 && !front.is_empty() && front.iter().all(|label| labels.contains(&label)), "{error}");

    let small = ["stability", "dam-break-2d", "--particles", "100", "--time", "0.1", "--json"];
    let stability = json(&[&small[..], &["--axis", "speed_of_sound=20,40"]].concat());
    has(&stability, &["suite", "runs[].label", "runs[].choice.speed_of_sound", "runs[].outcome", "runs[].detail"]);
    let steps: Vec<f64> = [0, 1].map(|i| stability["runs"][i]["time_step"].as_f64().expect("a step is stable")).into();
    assert!(steps[0] > steps[1] && steps[1] > 0.0, "twice the sound takes shorter steps: {stability}");

    let tower = json(&["stability", "tower", "--time", "0.02", "--json"]);
    has(&tower, &["suite", "runs[].label", "runs[].choice", "runs[].outcome", "runs[].detail", "runs[].series"]);

    let scenes = json(&["scenes", "--json"]);
    let names: Vec<&str> = scenes.as_array().expect("a list").iter().filter_map(|s| s["name"].as_str()).collect();
    let known = [
        "dam-break",
        "dam-break-2d",
        "dam-break-classic",
        "still-tank",
        "thesis-cube",
        "viscosity-cubes",
        "channel",
        "corrected-column",
        "stiff-tank",
        "elastic-cube",
        "two-fluids",
        "two-jets",
        "jet",
        "splash",
        "obstacle",
        "obstacles",
        "funnel",
        "sloshing",
        "falling-column",
        "adhesion",
        "thesis-jet",
        "oil-and-water",
        "drop",
        "tower",
    ];
    assert_eq!(names, known);
}

#[test]
fn one_field_can_be_set() {
    let slow = json(&["run", "dam-break-2d", "--steps", "2", "--set", "gravity=(0, -1, 0)", "--json"]);
    let plain = json(&["run", "dam-break-2d", "--steps", "2", "--json"]);
    assert_ne!(slow["hash"], plain["hash"]);
    let named = json(&["run", "dam-break-2d", "--steps", "2", "--set", "fluid.speed_of_sound=25", "--json"]);
    assert_eq!(named["hash"], plain["hash"], "set to what it was");
}

#[test]
fn numbers_out_of_range_are_refused_with_status_2() {
    for (option, value, message) in [("--threads", "5000", "5000 is not in 0..=1024"), ("--steps", "-1", "'-1'")] {
        let folder = tempfile::tempdir().expect("a folder");
        let output = millpond(folder.path(), &["run", "dam-break", option, value]);
        let err = String::from_utf8_lossy(&output.stderr);
        assert_eq!(output.status.code(), Some(2), "{err}");
        assert!(err.contains(message) && err.contains(option), "{err}");
    }
}

#[test]
fn bad_calls_are_refused_with_status_2() {
    let folder = tempfile::tempdir().expect("a folder");
    let calls: [(&[&str], &str); 20] = [
        (&["run", "no-such-scene"], "no scene \"no-such-scene\""),
        (&["run", "no-such-file.ron"], "no-such-file.ron"),
        (&["run", "dam-break", "--set", "no_such_field=1"], "no field no_such_field"),
        (&["run", "dam-break", "--set", "time_stp=1"], "no field time_stp; did you mean time_step?"),
        (&["run", "dam-break", "--set", "recovery=ShortenStep(times: 99)"], "recovery.times is 99"),
        (&["run", "dam-break", "--set", "blocks=[]"], "blocks and emitters are empty"),
        (&["run", "dam-break", "--set", "time_step"], "FIELD=VALUE"),
        (&["run", "dam-break", "--set", "time_step=fast"], "invalid type"),
        (&["run", "dam-break", "--set", "dimension=Four"], "Four"),
        (&["run", "dam-break", "--time", "NaN"], "--time"),
        (&["run", "dam-break", "--particles", "100000000"], "bytes"),
        (&["run", "dam-break", "--set", "fluid.rest_density=-1"], "fluids[0].rest_density is -1"),
        (&["error", "no-such-case"], "no case"),
        (&["error", "still-tank", "--set", "time_step=0.001"], "what the study varies"),
        (&["error", "still-tank", "--particles", "100"], "no meaning"),
        (&["stability", "dam-break", "--axis", "no_such_axis"], "NAME=VALUE"),
        (&["stability", "dam-break", "--axis", "no_such_field=1"], "no field no_such_field"),
        (&["stability", "dam-break", "--axis", "density_ratio"], "the scene has one fluid"),
        (&["stability", "dam-break", "--time", "NaN"], "--time NaN"),
        (&["stability", "tower", "--set", "time_step=0.001"], "what the suite varies"),
    ];
    for (call, message) in calls {
        let output = millpond(folder.path(), call);
        let err = String::from_utf8_lossy(&output.stderr);
        assert_eq!(output.status.code(), Some(2), "{call:?}: {err}");
        assert!(err.contains(message), "{call:?}: {err}");
        assert_eq!(err.trim().lines().count(), 1, "{call:?}: one clear message: {err}");
        assert!(output.stdout.is_empty(), "{call:?}");
    }
    assert_eq!(std::fs::read_dir(folder.path()).expect("a folder").count(), 0, "nothing is written");
}

#[test]
fn bad_scene_files_are_named_with_line_and_field() {
    let good = include_str!("../scenes/dam-break-2d.ron");
    let line_of = |text: &str| good.lines().position(|line| line.contains(text)).expect("it is there") + 1;
    let particles = ("particle_spacing: 0.025,", "particle_spacing: 0.025, particle_weight: 2.0,");
    let cases = [
        (particles, "particle_weight", line_of("particle_spacing")),
        (("time_step: 0.0005", "time_step: \"fast\""), "time_step", line_of("time_step")),
        (("size: (1.0, 2.0, 0.0)", "size: (9.0, 2.0, 0.0)"), "blocks[0] reaches", line_of("blocks:")),
        (("rest_density: 1000.0", "rest_density: -1000.0"), "rest_density is -1000", line_of("rest_density")),
        (("gravity: (0.0, -9.81, 0.0)", "gravity: (0.0, NaN, 0.0)"), "gravity is NaN", line_of("gravity")),
        (("dimension: Two", "dimension: Seven"), "Seven", line_of("dimension")),
        (("high: (4.0, 3.0, 0.0)", "high: (4.0, 3.0, 0.0), slip: 1.5"), "slip is 1.5", line_of("container:")),
        (("cells: (64, 48, 1)", "cells: (2, 48, 1)"), "grid.cells has 2 along x", line_of("grid: (cells")),
    ];
    let folder = tempfile::tempdir().expect("a folder");
    for ((from, to), message, line) in cases {
        let text = good.replace(from, to);
        assert_ne!(text, good, "{from}");
        std::fs::write(folder.path().join("bad.ron"), text).expect("it can be written");
        let output = millpond(folder.path(), &["run", "bad.ron", "--out", "pictures"]);
        let err = String::from_utf8_lossy(&output.stderr);
        assert_eq!(output.status.code(), Some(2), "{to}: {err}");
        assert!(err.contains(message) && err.contains(&format!("bad.ron:{line}")), "{to}, line {line}: {err}");
        assert!(!folder.path().join("pictures").exists(), "nothing is written");
    }
    std::fs::write(folder.path().join("bad.ron"), "this is no scene").expect("it can be written");
    let output = millpond(folder.path(), &["run", "bad.ron"]);
    assert_eq!(output.status.code(), Some(2));
    assert!(String::from_utf8_lossy(&output.stderr).contains("bad.ron:1: "));
}

#[test]
fn a_recipe_can_be_set_and_is_named() {
    let recipe = |set: &[&str]| {
        let call = [&["plan", "dam-break-2d", "--steps", "0", "--json"][..], set].concat();
        json(&call)["formulas"].clone()
    };
    assert_eq!(recipe(&[])["recipe"], "FreeSurface");
    let set = recipe(&["--set", "recipe=Impact", "--set", "model.xsph=0.1"]);
    assert_eq!((&set["recipe"], &set["differs_in"][0]), (&"Impact".into(), &"xsph".into()));
    let folder = tempfile::tempdir().expect("a folder");
    let unknown = millpond(folder.path(), &["plan", "dam-break-2d", "--set", "recipe=Soup"]);
    let err = String::from_utf8_lossy(&unknown.stderr);
    assert!(unknown.status.code() == Some(2) && err.contains("Soup") && err.contains("FreeSurface"), "{err}");
}

#[test]
fn gauges_show_the_same_on_both_backends() {
    let folder = tempfile::tempdir().expect("a folder");
    // at the wall where the water stands
    let here = include_str!("../scenes/dam-break-2d.ron")
        .replace("Pressure((4.0,", "Pressure((0.0,")
        .replace("Level((2.0,", "Level((0.5,")
        .replace("ForceOnFace(Right)", "ForceOnFace(Left)");
    std::fs::write(folder.path().join("here.ron"), here).expect("it can be written");
    let gauges = |backend: &str, every: &str| {
        let steps = ["run", "here.ron", "--particles", "800", "--steps", "12", "--gauges-every", every];
        let output = millpond(folder.path(), &[&steps[..], &["--out", backend, "--backend", backend]].concat());
        let series = std::fs::read_to_string(folder.path().join(backend).join("gauges.csv")).unwrap_or_default();
        (output.status.code(), series, String::from_utf8_lossy(&output.stderr).into_owned())
    };
    let (status, on_cpu, err) = gauges("cpu", "0.002");
    assert_eq!(status, Some(0), "{err}");
    // a title, the start, and every fourth of 12 steps of 0.5 ms
    assert_eq!(on_cpu.lines().count(), 5, "{on_cpu}");
    let last: Vec<f32> = on_cpu.lines().last().expect("lines").split(',').map(|x| x.parse().expect("x")).collect();
    // 800 particles are half as high as the 2 m of the scene; pressure has only begun to rise from the floor
    assert!(last[1] > 100.0 && (last[2] - 1.0).abs() < 0.05 && last[3] < -50.0, "{last:?}");
    let (_, often, _) = gauges("cpu", "1e-30");
    assert_eq!(often.lines().count(), 14, "every step, and none twice: {often}");
    assert_eq!(gauges("cpu", "0").0, Some(2));
    match gauges("gpu", "0.002") {
        (Some(3), _, err) if std::env::var_os("MILLPOND_REQUIRE_GPU").is_none_or(|v| v != "1") => eprintln!("{err}"),
        (status, on_gpu, err) => assert_eq!((status, on_gpu), (Some(0), on_cpu), "{err}"),
    }
}

#[test]
fn a_cell_past_its_capacity_is_refused() {
    let folder = tempfile::tempdir().expect("a folder");
    let lists = r#"grid.structure={"CellLists":{"places":2}}"#;
    let output = millpond(folder.path(), &["run", "dam-break-2d", "--set", lists]);
    let err = String::from_utf8_lossy(&output.stderr);
    assert!(err.contains("particles and has 2 places"), "{err}");
    assert_eq!(output.status.code(), Some(2), "the scene cannot start, so the scene is wrong: {err}");
}

#[test]
fn a_step_that_fails_ends_with_status_1() {
    let folder = tempfile::tempdir().expect("a folder");
    let output = millpond(folder.path(), &["run", "dam-break-2d", "--set", "time_step=0.5", "--steps", "200"]);
    let err = String::from_utf8_lossy(&output.stderr);
    assert_eq!(output.status.code(), Some(1), "{err}");
    assert!(err.contains("step "), "{err}");
}

#[test]
fn a_map_goes_on_where_it_was_cut_off() {
    let folder = tempfile::tempdir().expect("a folder");
    let listed = ["--axis", "speed_of_sound=20,40", "--axis", "time_step=1e-3,1e-1", "--out", "map", "--json"];
    let call = [&["stability", "dam-break-2d", "--particles", "100", "--time", "0.1"][..], &listed[..]].concat();
    let first = millpond(folder.path(), &call);
    assert_eq!(first.status.code(), Some(0), "{}", String::from_utf8_lossy(&first.stderr));
    for name in ["stability.json", "stability.jsonl", "stability.md", "stability.svg"] {
        assert!(folder.path().join("map").join(name).exists(), "{name}");
    }
    let path = folder.path().join("map/stability.jsonl");
    let text = std::fs::read_to_string(&path).expect("it is there");
    // a finished point is not run again: if it were, it would be stable
    let told = text.replacen("\"outcome\":\"stable\"", "\"outcome\":\"refused\"", 1);
    assert_ne!(told, text, "some step is stable");
    std::fs::write(&path, &told[..told.len() - 20]).expect("it can be cut");
    let outcomes = |output: &Output| -> Vec<String> {
        let document: Value = serde_json::from_slice(&output.stdout).expect("one document");
        let runs = document["runs"].as_array().expect("a list").iter();
        runs.map(|run| run["outcome"].as_str().unwrap_or_default().to_owned()).collect()
    };
    let second = outcomes(&millpond(folder.path(), &call));
    assert_eq!(second.iter().filter(|outcome| *outcome == "refused").count(), 1, "{second:?}");
    let fresh = outcomes(&millpond(folder.path(), &[&call[..], &["--fresh"]].concat()));
    assert_eq!(fresh, outcomes(&first));
    assert_eq!(fresh, ["stable", "unstable", "stable", "unstable"]);
}

#[test]
fn a_result_that_cannot_be_written_ends_with_status_4() {
    let folder = tempfile::tempdir().expect("a folder");
    std::fs::write(folder.path().join("file"), "no folder").expect("a file");
    let output = millpond(folder.path(), &["run", "dam-break-2d", "--steps", "1", "--out", "file/out"]);
    let err = String::from_utf8_lossy(&output.stderr);
    assert_eq!(output.status.code(), Some(4), "{err}");
    assert!(err.contains("cannot be written"), "{err}");
    // a picture of the plotter's, where a folder stands
    let map = [
        "stability",
        "dam-break",
        "--particles",
        "400",
        "--axis",
        "time_step=0.0001",
        "--time",
        "0.01",
        "--out",
        "map",
    ];
    let drawn = millpond(folder.path(), &map);
    assert_eq!(drawn.status.code(), Some(0), "{}", String::from_utf8_lossy(&drawn.stderr));
    let svg =
        std::fs::read_dir(folder.path().join("map")).expect("a folder").map(|entry| entry.expect("an entry").path());
    let svg = svg.filter(|path| path.extension().is_some_and(|e| e == "svg")).last().expect("a picture");
    std::fs::remove_file(&svg).expect("its file");
    std::fs::create_dir(&svg).expect("a folder");
    let output = millpond(folder.path(), &map);
    assert_eq!(output.status.code(), Some(4), "{}", String::from_utf8_lossy(&output.stderr));
}

#[test]
fn a_conflict_names_the_argument_that_makes_it() {
    let folder = tempfile::tempdir().expect("a folder");
    for (arguments, origin) in [
        (["run", "stiff-tank", "--set", "integrator=Verlet"], "--set integrator=Verlet: adaptive conflicts"),
        (["run", "two-fluids", "--set", "fluids.1.rest_density=-1"], "--set fluids.1.rest_density=-1: fluids[1]."),
        (["run", "dam-break", "--set", "blocks.0.size=[9,2,0.8]"], "--set blocks.0.size=[9,2,0.8]: blocks[0]"),
        (["run", "dam-break", "--set", "grid.cells.0=2"], "--set grid.cells.0=2: grid.cells"),
    ] {
        let output = millpond(folder.path(), &arguments);
        let err = String::from_utf8_lossy(&output.stderr);
        assert!(output.status.code() == Some(2) && err.contains(origin), "{arguments:?}: {err}");
    }
}

#[test]
fn a_run_writes_its_pictures_and_its_report() {
    let folder = tempfile::tempdir().expect("a folder");
    let call = ["run", "thesis-cube", "--particles", "200", "--steps", "4", "--out", "here", "--frames", "3", "--json"];
    let output = millpond(folder.path(), &call);
    assert_eq!(output.status.code(), Some(0), "{}", String::from_utf8_lossy(&output.stderr));
    for name in ["report.md", "thesis-cube-0000.png", "thesis-cube-0001.png", "thesis-cube-0002.png"] {
        let length =
            std::fs::metadata(folder.path().join("here").join(name)).unwrap_or_else(|e| panic!("{name}: {e}")).len();
        assert!(length > 100, "{name}");
    }
}
