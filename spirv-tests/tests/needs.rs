//! Modules hold what their scenes need and nothing else.

use std::collections::BTreeSet;

use prefilter::Scene;
use spirv_tests::report::needs::{calls, code, features, scenes, Need};

type Outcome = Result<(), Box<dyn std::error::Error + Send + Sync>>;

/// The names of a scene's code.
fn names(scene: &Scene) -> Result<BTreeSet<String>, prefilter::Error> {
    let code = code(scene.module()?.wgsl());
    let part = |letter: char| letter.is_ascii_alphanumeric() || letter == '_';
    Ok(code.split(|letter| !part(letter)).filter(|name| !name.is_empty()).map(str::to_owned).collect())
}

#[test]
fn features_switched_off_leave_no_trace() -> Outcome {
    let mut findings = Vec::new();
    for features::Feature { name, on, off, never, words } in features::all()? {
        let [on_names, off_names] = [names(&on)?, names(&never)?];
        let without = never.module()?;
        println!("{name}: {:?}", on_names.difference(&off_names).collect::<Vec<_>>());
        let switched_off = off.map(|off| off.module()).transpose()?;
        if switched_off.is_some_and(|off| off.wgsl() != without.wgsl()) {
            findings.push(format!("{name}: switched off, the text is not that of a scene that never had it"));
        }
        if words.is_empty() {
            findings.push(format!("{name} has no words of its own"));
        }
        let missing = words.iter().filter(|word| !on_names.contains(**word));
        findings.extend(missing.map(|word| format!("{name}: no `{word}` where it is on")));
        let left = words.iter().filter(|word| off_names.contains(**word));
        findings.extend(left.map(|word| format!("{name}: `{word}` where it is off")));
    }
    assert!(findings.is_empty(), "{}", findings.join("\n"));
    Ok(())
}

#[test]
fn a_feature_that_is_left_on_is_found() -> Outcome {
    let all = features::all()?;
    assert!(all.len() >= 20, "{}", all.len());
    for features::Feature { name, on, never, .. } in all {
        assert_ne!(on.module()?.wgsl(), never.module()?.wgsl(), "{name}");
    }
    Ok(())
}

#[test]
fn twenty_scenes_state_what_they_need() -> Outcome {
    let all = scenes::all()?;
    assert_eq!(all.len(), 20);
    for (name, scene) in all {
        let module = scene.module()?;
        let need = Need::of(&module);
        println!("{name}: {need:?}");
        assert!(need.lines > 0 && need.operations > 0 && need.numbers > 0, "{name}: {need:?}");
        assert_eq!(need.table_bytes, module.tables().iter().map(prefilter::Table::bytes).sum::<usize>(), "{name}");
    }
    Ok(())
}

#[test]
fn code_has_no_comments_and_no_empty_lines() {
    assert_eq!(code("/// A.\n\nfn a() { // b\n    return; \n}\n"), "fn a() {\n    return;\n}\n");
}

/// One line for a texture, up to three for heights, and naga knows the functions by those arguments.
#[test]
fn the_papers_cases_are_called_in_few_lines() -> Outcome {
    for (call, most) in calls::all()?.iter().zip([1, 3, 1]) {
        println!("{}:\n{}", call.name, call.lines);
        assert_eq!(call.lines.lines().count(), most, "{}", call.name);
        assert!(call.lines.lines().all(|line| line.len() <= 120), "{}", call.name);
        for export in call.module.exports() {
            assert!(call.lines.contains(&format!("{}(", export.name)), "{} is not called", export.name);
        }
        assert!(!call.shader.spirv()?.is_empty());
    }
    Ok(())
}
