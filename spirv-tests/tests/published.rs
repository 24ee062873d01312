//! The README's tables are those of the published reports.

use std::path::Path;

use spirv_tests::report::publish;

const README: &str = include_str!("../../README.md");

#[test]
fn the_readme_has_the_tables_of_published_reports() -> std::io::Result<()> {
    let reports = publish::published(&Path::new(env!("CARGO_MANIFEST_DIR")).join(".."))?;
    assert!(reports.iter().any(|(name, _)| name == "report-llvmpipe.md"), "there is no report of llvmpipe");
    assert_eq!(publish::with_tables(README, &reports), README, "`cargo xtask report --publish` writes them");
    assert!(README.contains("[docs/report-llvmpipe.md]"), "the README has no place for tables");
    Ok(())
}
