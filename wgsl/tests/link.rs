//! What the linker takes from the shelf, and what it refuses.

use prefilter_wgsl::{collisions, declarations, link, mentioned, nearest, FILES};

/// The names of the shelf declarations behind a text.
fn names(text: &str) -> Vec<&'static str> {
    mentioned(text).into_iter().map(|(_, declaration)| declaration.name).collect()
}

#[test]
fn a_text_that_mentions_nothing_is_returned_as_it_is() {
    for text in ["", "\n", "fn a() {}", "fn a() {}\r\n", "\u{feff}fn a() {}", "// normal_cdf"] {
        assert_eq!(link(text).as_deref(), Ok(text));
    }
}

#[test]
fn the_text_comes_first_byte_for_byte() {
    for text in ["fn a() { normal_cdf(1.0); }", "fn a() { normal_cdf(1.0); }\r\n\r\n", "normal_cdf // no line break"] {
        let linked = link(text).expect("no collision");
        let behind = linked.strip_prefix(text).expect("the text is first");
        assert!(behind.starts_with('\n') && behind.ends_with("}\n"), "{linked}");
        assert_eq!(declarations(behind).len(), 1);
    }
}

#[test]
fn names_are_followed_through_the_shelf_and_stand_once_in_its_order() {
    let shelf: Vec<&str> = FILES.iter().flat_map(|file| declarations(file.text)).map(|found| found.name).collect();
    for text in ["texture_step(1, 2) + normal_cdf(3) + texture_step(4, 5)", "normal_cdf(3) * texture_step(1, 2)"] {
        let names = names(text);
        assert!(names.contains(&"texture_step") && names.contains(&"normal_cdf"), "{names:?}");
        let order: Vec<_> = names.iter().map(|name| shelf.iter().position(|other| other == name)).collect();
        assert!(order.windows(2).all(|pair| pair[0] < pair[1]), "{names:?}");
        assert_eq!(link(text).map(|linked| declarations(&linked).len()), Ok(names.len()));
    }
    assert_eq!(names("texture_step"), names("texture_step + normal_cdf"), "one needs the other");
}

#[test]
fn comments_come_along_to_the_byte() {
    for (path, declaration) in FILES.iter().flat_map(|file| mentioned(file.text)) {
        let file = FILES.iter().find(|file| file.path == path).expect("the shelf names its files");
        assert!(file.text.contains(declaration.text));
        assert!(!declaration.documentation().is_empty(), "{path}: {} has no comment", declaration.name);
        let linked = link(declaration.name).expect("a name alone declares nothing");
        assert!(linked.contains(&format!("\n{}\n", declaration.text)), "{linked}");
    }
}

#[test]
fn no_name_of_the_shelf_is_declared_twice() {
    let mut names: Vec<&str> = FILES.iter().flat_map(|file| declarations(file.text)).map(|found| found.name).collect();
    let count = names.len();
    names.sort_unstable();
    names.dedup();
    assert_eq!(names.len(), count);
    assert!(count > 0);
}

#[test]
fn a_declared_shelf_name_is_refused_with_both_places() {
    let text = "// one\nfn ok() {}\n  struct normal_cdf { x: f32 }\nconst grid_linear = 1;";
    let found = collisions(text);
    let line = |name: &str, path: &str| {
        let file = FILES.iter().find(|file| file.path == path).expect("the file exists");
        file.text.lines().position(|line| line.contains(&format!("fn {name}("))).expect("the function exists") + 1
    };
    let [normal, grid] = [line("normal_cdf", "math/normal.wgsl"), line("grid_linear", "math/grid.wgsl")];
    let messages: Vec<String> = found.iter().map(ToString::to_string).collect();
    assert_eq!(
        messages,
        [
            format!("3:10: `normal_cdf` is declared here and by the shelf at math/normal.wgsl:{normal}; rename yours"),
            format!("4:7: `grid_linear` is declared here and by the shelf at math/grid.wgsl:{grid}; rename yours"),
        ]
    );
    assert_eq!(link(text), Err(found[0].clone()));
    assert!(link(&link("normal_cdf").expect("links")).is_err(), "a linked text declares what it was given");
}

/// A built-in function that `normal_cdf` calls.
fn built_in() -> &'static str {
    let found = mentioned("normal_cdf").into_iter().find(|(_, declaration)| declaration.name == "normal_cdf");
    let text = found.expect("the shelf has the function").1.text;
    let calls = |name: &&str| text.contains(&format!("{name}("));
    ["select", "max", "min", "abs", "clamp", "exp"].into_iter().find(calls).expect("it calls one of these")
}

#[test]
fn a_text_may_not_change_what_the_shelf_computes() {
    let name = built_in();
    let text = format!("fn a() {{ normal_cdf(1.0); }}\nfn {name}(a: f32) -> f32 {{ return a; }}");
    let collision = link(&text).expect_err("`normal_cdf` would call this function");
    assert_eq!((collision.line, collision.column, collision.replaced_in), (2, 4, Some("normal_cdf")));
    let message = collision.to_string();
    let start =
        format!("2:4: `{name}` is declared here and hides the built-in that `normal_cdf` of the shelf uses at math/");
    assert!(message.starts_with(&start), "{message}");
    // Through another function, and as a type.
    assert!(link(&format!("fn a() {{ texture_step(1.0, 1.0); }}\nconst {name} = 1;")).is_err());
    assert!(link("fn a() { normal_cdf(1.0); }\nalias f32 = i32;").is_err());
}

#[test]
fn other_names_are_the_texts_own() {
    let name = built_in();
    for text in [
        // A built-in that nothing needs, one that no needed function uses, and a parameter of a needed one.
        format!("fn {name}() {{}}"),
        "fn a() { normal_cdf(1.0); }\nfn smoothstep() {}".to_owned(),
        "fn a() { normal_cdf(1.0); }\nvar<private> x: f32;".to_owned(),
        // Names inside the text's own functions.
        format!("fn a(normal_cdf: f32) {{ let {name} = 1; var f32 = 2; const texture_step = 3; }}"),
    ] {
        assert_eq!(collisions(&text), [], "{text}");
    }
}

#[test]
fn misspelled_names_find_their_neighbors() {
    assert_eq!(nearest("normal_cfd", ""), Some("normal_cdf"));
    assert_eq!(nearest("texture_steps", ""), Some("texture_step"));
    assert_eq!(nearest("normal_cdf", ""), Some("normal_cdf"));
    assert_eq!(nearest("lichen_colour", "fn lichen_color() {}"), Some("lichen_color"));
    for far in ["", "x", "höhe", "vec5", "completely_different", "cdf"] {
        assert_eq!(nearest(far, ""), None, "{far}");
    }
}
