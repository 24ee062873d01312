//! The report as files: pictures, the sheet, the table, and a page that shows them.

use super::judge::{Judged, Sizes};
use super::method::Method;
use super::{sheet, table, Error};
use crate::imaging::picture::Picture;
use std::fmt::Write;
use std::path::Path;

const HEAD: &str = include_str!("page.html");

/// The demo `noise` writes its picture and its table next to the page.
const NOISE: &str = "<h2>noise, on a plane and in blocks</h2>
<p>Noise of which nothing is stored, filtered where it is evaluated, <a href=\"noise.csv\">the errors as a
table</a>.</p>
<img src=\"noise.png\" alt=\"noise by nine methods and in truth; made by the binary noise\">
";

/// So does `rough`.
const ROUGH: &str = "<h2>a rough surface, colored by height</h2>
<p>Valleys hide at grazing angles and lie in shadow, <a href=\"rough.csv\">the errors as a table</a>.</p>
<img src=\"rough.png\" alt=\"a rough surface by three methods and in truth; made by the binary rough\">
";

/// And so does `snake`.
const SNAKE: &str = "<h2>a snake, colored by a pattern and by the slopes of its scales</h2>
<p>Scales are red on one side: which side is seen depends on where the body goes, <a href=\"snake.csv\">the errors as a
table</a>.</p>
<img src=\"snake.png\" alt=\"a snake by three methods and in truth, near and far; made by the binary snake\">
";

/// And so does `cliffs`.
const CLIFFS: &str = "<h2>mountains in the light of a sky</h2>
<p>Rock where it is steep, snow where it is high and flat, under a sky with a sun, <a href=\"cliffs.csv\">the errors as
a table</a>.</p>
<img src=\"cliffs.png\" alt=\"mountains by several methods and in truth; made by the binary cliffs\">
";

/// And so does `moss`.
const MOSS: &str = "<h2>moss and a sponge on a log</h2>
<p>Heights that a curve makes of noise, near and far, from overhead to a silhouette, <a href=\"moss.csv\">the errors as
a table</a>.</p>
<img src=\"moss.png\" alt=\"moss and a sponge by three methods and in truth; made by the binary moss\">
";

/// A picture's name in file names and its label.
struct Column<'a> {
    stem: String,
    label: String,
    picture: &'a Picture,
    frames: Vec<&'a [Picture]>,
}

/// Writes the whole report into a folder, which is made if need be. `sheet` holds the pictures of the contact sheet.
///
/// # Errors
/// Those of the file system and of the PNG encoder.
pub fn write(folder: &Path, device: &str, sizes: Sizes, all: &[Judged], sheet: &[Judged]) -> Result<(), Error> {
    let failed = |path: &Path| {
        let path = path.to_path_buf();
        move |error| Error::File { path, error }
    };
    std::fs::create_dir_all(folder).map_err(failed(folder))?;
    sheet::sheet(sheet).save_indexed(&folder.join("demo.png"))?;
    for judged in all {
        pictures(folder, judged)?;
    }
    for (name, text) in [("demo.csv", table::csv(all)), ("index.html", html(device, sizes, all))] {
        let path = folder.join(name);
        std::fs::write(&path, text).map_err(failed(&path))?;
    }
    Ok(())
}

fn columns(judged: &Judged) -> Vec<Column<'_>> {
    let shown = Method::SHOWN.iter().filter_map(|&method| judged.row(method)).map(|row| Column {
        stem: row.method.stem(),
        label: row.method.label(),
        picture: &row.picture,
        frames: row.frames.iter().map(Vec::as_slice).collect(),
    });
    let truth = Column {
        stem: "truth".into(),
        label: "truth".into(),
        picture: &judged.truth,
        frames: judged.motions.iter().map(|moving| moving.frames.as_slice()).collect(),
    };
    shown.chain([truth]).collect()
}

fn pictures(folder: &Path, judged: &Judged) -> Result<(), Error> {
    for column in columns(judged) {
        let file = |kind: &str| folder.join(format!("{}_{}{kind}.png", judged.name, column.stem));
        sheet::still(column.picture, None).save(&file(""))?;
        if column.stem != "truth" {
            sheet::still(column.picture, Some(&judged.truth)).save(&file("_error"))?;
        }
        for (moving, frames) in judged.motions.iter().zip(&column.frames) {
            sheet::strip(frames).save(&file(&format!("_{}", moving.motion.label())))?;
        }
    }
    Ok(())
}

fn html(device: &str, sizes: Sizes, all: &[Judged]) -> String {
    let mut page = HEAD.to_owned();
    let [width, height] = sizes.moving;
    let _ = writeln!(
        page,
        "<style>.moving {{ width: {width}px; height: {height}px; animation: {}s steps({}) infinite alternate play; }}\n\
         @keyframes play {{ to {{ background-position-y: -{}px; }} }}</style>",
        0.1 * sizes.frames as f64,
        sizes.frames,
        sizes.frames * height,
    );
    let _ = writeln!(page, "<pre>{}</pre>", escaped(&table::legend(device, sizes.still)));
    for judged in all {
        section(&mut page, judged);
    }
    page + NOISE + ROUGH + SNAKE + CLIFFS + MOSS + "</main>\n"
}

fn section(page: &mut String, judged: &Judged) {
    let _ = writeln!(page, "<h2>{}</h2>\n<pre>{}</pre>", judged.title, escaped(&table::text(judged)));
    let name = judged.name;
    page.push_str("<div class=\"grid\">\n");
    for Column { stem, label, .. } in columns(judged) {
        let _ = write!(page, "<figure><figcaption>{label}</figcaption><img src=\"{name}_{stem}.png\" alt=\"{label}\">");
        if stem != "truth" {
            let _ = write!(page, "<img src=\"{name}_{stem}_error.png\" alt=\"errors of {label}\">");
        }
        page.push_str("</figure>\n");
    }
    page.push_str("</div>\n");
    for (number, moving) in judged.motions.iter().enumerate() {
        let motion = moving.motion.label();
        let _ = writeln!(page, "<h3>{motion}</h3>\n<div class=\"grid\">");
        for Column { stem, label, frames, .. } in columns(judged) {
            if frames.get(number).is_some() {
                let style = format!("background-image: url({name}_{stem}_{motion}.png)");
                let _ = write!(page, "<figure><figcaption>{label}</figcaption>");
                let _ = writeln!(page, "<div class=\"moving\" style=\"{style}\"></div></figure>");
            }
        }
        page.push_str("</div>\n");
    }
}

fn escaped(text: &str) -> String {
    text.replace('&', "&amp;").replace('<', "&lt;").replace('>', "&gt;")
}
