//! A changed shader is validated again by the next `cargo build`.

use std::path::Path;
use std::process::Command;

const MANIFEST: &str = "\
[package]
name = \"shader-user\"
version = \"0.0.0\"
edition = \"2021\"
publish = false

[workspace]

[dependencies]
prefilter-macros = { path = '@' }
";
const LIB: &str = "pub const SHADER: &str = prefilter_macros::include_wgsl!(\"shader.wgsl\");\n";
const GOOD: &str = "fn snow(height: f32) -> f32 {\n    return normal_cdf(height);\n}\n";

fn cargo() -> Command {
    Command::new(std::env::var_os("CARGO").unwrap_or_else(|| "cargo".into()))
}

/// The target triple of this machine.
fn host() -> String {
    let output = cargo().arg("-vV").output().expect("cargo runs");
    let text = String::from_utf8(output.stdout).expect("cargo writes UTF-8");
    text.lines().find_map(|line| line.strip_prefix("host: ")).expect("cargo names its host").to_owned()
}

/// Builds the crate in a folder offline and returns whether it was built, and what cargo said.
fn build(folder: &Path) -> (bool, String) {
    let mut command = cargo();
    // The folder, the target and the flags of trybuild, which builds naga for `compile.rs`: once is enough.
    command.args(["build", "--offline", "--color=never", "--target", &host()]).current_dir(folder);
    command.env("CARGO_TARGET_DIR", Path::new(env!("CARGO_TARGET_TMPDIR")).with_file_name("tests/trybuild"));
    let output = command.env_remove("RUSTFLAGS").output().expect("cargo runs");
    (output.status.success(), String::from_utf8_lossy(&output.stderr).into_owned())
}

#[test]
fn a_changed_shader_is_validated_again() {
    let macros = Path::new(env!("CARGO_MANIFEST_DIR"));
    let folder = Path::new(env!("CARGO_TARGET_TMPDIR")).join("shader-user");
    std::fs::create_dir_all(folder.join("src")).expect("the build folder can be written");
    let write =
        |name: &str, text: &str| std::fs::write(folder.join(name), text).expect("the build folder can be written");
    write("Cargo.toml", &MANIFEST.replace('@', &macros.display().to_string()));
    write("src/lib.rs", LIB);
    // The workspace's versions are the ones that lie on this machine.
    std::fs::copy(macros.with_file_name("Cargo.lock"), folder.join("Cargo.lock"))
        .expect("the workspace has a lock file");

    write("shader.wgsl", GOOD);
    let (built, said) = build(&folder);
    assert!(built, "{said}");
    let (built, said) = build(&folder);
    assert!(built && !said.contains("Compiling"), "nothing changed: {said}");

    write("shader.wgsl", &GOOD.replace("normal_cdf", "normal_cfd"));
    let (built, said) = build(&folder);
    assert!(!built, "the change went unnoticed: {said}");
    assert!(said.contains("error: shader.wgsl:2:12: "), "{said}");

    write("shader.wgsl", GOOD);
    let (built, said) = build(&folder);
    assert!(built && said.contains("Compiling shader-user"), "{said}");
}
