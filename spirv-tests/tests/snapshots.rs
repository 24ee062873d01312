//! Did the text change? One snapshot a scene, reviewed as a diff.

use spirv_tests::scenes;

#[test]
fn every_scene_keeps_its_text() -> Result<(), Box<dyn std::error::Error + Send + Sync>> {
    for (name, scene) in scenes::all()? {
        let module = scene.module()?;
        let text = format!("{}\n{}", module.explain(), module.wgsl());
        insta::with_settings!({ omit_expression => true, prepend_module_to_snapshot => false }, {
            insta::assert_snapshot!(name, text);
        });
    }
    Ok(())
}
