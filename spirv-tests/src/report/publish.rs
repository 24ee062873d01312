//! The report in the repository: a Markdown text for every device, and from these a table in the README.

use super::document::{Document, Item};
use super::{markdown, Error};
use std::path::{Path, PathBuf};

/// The table that the README shows of every device.
pub const SHOWN: &str = "filters_summary";

/// Between these lines of the README stands what was made.
const MARKS: [&str; 2] = ["<!-- made by `cargo xtask report --publish` -->\n", "<!-- end of what was made -->\n"];

/// Writes `docs/report-DEVICE.md` below the workspace's folder and the README's tables anew; returns what was written.
///
/// Plots and pictures are left out: the report that anyone can make has them.
///
/// # Errors
/// Those of the file system.
pub fn publish(root: &Path, device: &str, document: &Document) -> Result<Vec<PathBuf>, Error> {
    let failed = |path: &Path| {
        let path = path.to_path_buf();
        move |error| Error::File { path, error }
    };
    let mut words = document.clone();
    for section in &mut words.sections {
        section.items.retain(|item| !matches!(item, Item::Plot(_) | Item::Sheet(_)));
    }
    let report = root.join("docs").join(format!("report-{}.md", stem(device)));
    std::fs::write(&report, markdown::text(&words)).map_err(failed(&report))?;
    let reports = published(root).map_err(failed(&report))?;
    let readme = root.join("README.md");
    let text = std::fs::read_to_string(&readme).map_err(failed(&readme))?;
    let made = with_tables(&text, &reports);
    if made == text {
        return Ok(vec![report]);
    }
    std::fs::write(&readme, made).map_err(failed(&readme))?;
    Ok(vec![report, readme])
}

/// The texts of all published reports, by their names.
///
/// # Errors
/// Those of the file system.
pub fn published(root: &Path) -> std::io::Result<Vec<(String, String)>> {
    let mut reports = Vec::new();
    for entry in std::fs::read_dir(root.join("docs"))? {
        let path = entry?.path();
        let name = path.file_name().map_or(String::new(), |name| name.to_string_lossy().into_owned());
        if name.starts_with("report-") && name.ends_with(".md") {
            reports.push((name, std::fs::read_to_string(path)?));
        }
    }
    reports.sort();
    Ok(reports)
}

/// A README with the tables of all reports between its marks; as it is where it has no marks.
pub fn with_tables(readme: &str, reports: &[(String, String)]) -> String {
    let parts = readme.split_once(MARKS[0]).and_then(|(before, rest)| Some((before, rest.split_once(MARKS[1])?.1)));
    let Some((before, after)) = parts else { return readme.to_owned() };
    let tables = reports.iter().map(|(name, report)| {
        let fact =
            |what: &str| report.lines().find_map(|line| line.strip_prefix(&format!("- {what}: "))).unwrap_or("?");
        let (date, extent) = (fact("date"), fact("extent"));
        format!("\n{}, {date}, {extent}: [docs/{name}](docs/{name})\n\n{}\n", fact("device"), table(report))
    });
    [before, MARKS[0], &tables.collect::<String>(), MARKS[1], after].concat()
}

/// The rows of the table that is shown.
fn table(report: &str) -> String {
    let begun = report.split_once(&markdown::mark(SHOWN)).map_or("", |(_, rest)| rest);
    let lines = begun.lines().skip_while(|line| !line.starts_with('|')).take_while(|line| line.starts_with('|'));
    lines.collect::<Vec<_>>().join("\n")
}

/// A device's name in a file's: its first words, up to what is in parentheses.
fn stem(device: &str) -> String {
    let name = device.split('(').next().unwrap_or(device).to_lowercase();
    let words = name.split(|letter: char| !letter.is_ascii_alphanumeric()).filter(|word| !word.is_empty());
    words.collect::<Vec<_>>().join("-")
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn devices_have_short_names() {
        assert_eq!(stem("llvmpipe (LLVM 15.0.6, 256 bits) (llvmpipe Mesa 22.3.6, Vulkan)"), "llvmpipe");
        assert_eq!(stem("NVIDIA H100 PCIe (NVIDIA 550, Vulkan)"), "nvidia-h100-pcie");
    }

    #[test]
    fn the_readme_has_the_table_of_every_report() {
        let report = |device: &str| {
            let (mark, table) = (markdown::mark(SHOWN), "*Rows.*\n\n| a |\n|---|\n| 1 |\n\n");
            format!("# A\n\n- device: {device}\n- date: today\n- extent: quick\n\n| no |\n\n{mark}{table}| no |\n")
        };
        let reports = [("report-a.md".to_owned(), report("A")), ("report-b.md".to_owned(), report("B"))];
        let readme = ["before\n", MARKS[0], "old\n", MARKS[1], "after\n"].concat();
        let made = with_tables(&readme, &reports);
        assert!(made.starts_with("before\n") && made.ends_with("after\n") && !made.contains("old"), "{made}");
        assert!(!made.contains("| no |") && made.matches("| a |\n|---|\n| 1 |\n").count() == 2, "{made}");
        assert!(made.contains("\nB, today, quick: [docs/report-b.md](docs/report-b.md)\n"), "{made}");
        assert_eq!(with_tables(&made, &reports), made);
        assert_eq!(with_tables("nothing", &reports), "nothing");
    }
}
