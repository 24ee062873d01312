//! Every scene's module through naga's other writers, and what they write through glslangValidator and spirv-val.

use std::error::Error;
use std::fs;
use std::path::{Path, PathBuf};
use std::process::Command;
use std::sync::OnceLock;

use prefilter::{Module, Shader, Stage};
use spirv_tests::scenes;

type Fault = Box<dyn Error + Send + Sync>;
type Outcome = Result<(), Fault>;

/// A scene's name, its module, and the fragment and the compute shader that call it.
type Probed = (&'static str, Module, [Shader; 2]);

/// All of them, made once: tables take a while to bake.
fn modules() -> Result<&'static [Probed], Fault> {
    static MODULES: OnceLock<Result<Vec<Probed>, String>> = OnceLock::new();
    let linked = |name, module: Module| -> Result<_, prefilter::Error> {
        let shaders = [module.link(&module.probe(Stage::Fragment))?, module.link(&module.probe(Stage::Compute))?];
        Ok((name, module, shaders))
    };
    let modules = MODULES.get_or_init(|| {
        let scenes = scenes::all().map_err(|error| error.to_string())?.into_iter();
        let each = scenes.map(|(name, scene)| scene.module().and_then(|module| linked(name, module)));
        each.collect::<Result<_, _>>().map_err(|error| error.to_string())
    });
    Ok(modules.as_deref().map_err(String::clone)?)
}

fn folder(name: &str) -> Result<PathBuf, Fault> {
    let folder = Path::new(env!("CARGO_TARGET_TMPDIR")).join(name);
    fs::create_dir_all(&folder)?;
    Ok(folder)
}

/// Runs a validator; a missing one is a failure that says how to get it.
fn accepted(program: &str, arguments: &[&str], file: &Path) -> Outcome {
    let output = Command::new(program)
        .args(arguments)
        .arg(file)
        .output()
        .map_err(|error| format!("{program}: {error}; `cargo xtask test` installs it"))?;
    if output.status.success() {
        return Ok(());
    }
    let said = [output.stdout, output.stderr].map(|bytes| String::from_utf8_lossy(&bytes).into_owned());
    Err(format!("{program} {} refuses {}: {}", arguments.join(" "), file.display(), said.concat()).into())
}

fn words(words: &[u32]) -> Vec<u8> {
    words.iter().flat_map(|word| word.to_le_bytes()).collect()
}

#[test]
fn spirv_is_valid_linked_and_unlinked() -> Outcome {
    let folder = folder("spirv")?;
    for (name, module, shaders) in modules()? {
        let library = folder.join(format!("{name}.unlinked.spv"));
        fs::write(&library, words(&module.spirv()?))?;
        accepted("spirv-val", &["--target-env", "spv1.3"], &library)?;
        for (stage, shader) in ["fragment", "compute"].iter().zip(shaders) {
            let file = folder.join(format!("{name}.{stage}.spv"));
            fs::write(&file, words(&shader.spirv()?))?;
            accepted("spirv-val", &["--target-env", "vulkan1.1"], &file)?;
        }
    }
    Ok(())
}

/// A caller of `terrain_texture`, which another library exports.
const CALLER: &str = r#"
    OpCapability Shader
    OpCapability Linkage
    OpMemoryModel Logical GLSL450
    OpDecorate %callee LinkageAttributes "terrain_texture" Import
    OpDecorate %caller LinkageAttributes "caller" Export
    %float = OpTypeFloat 32
    %color = OpTypeVector %float 3
    %kind = OpTypeFunction %color %float %float
    %callee = OpFunction %color None %kind
    %a = OpFunctionParameter %float
    %b = OpFunctionParameter %float
    OpFunctionEnd
    %caller = OpFunction %color None %kind
    %c = OpFunctionParameter %float
    %d = OpFunctionParameter %float
    %label = OpLabel
    %result = OpFunctionCall %color %callee %c %d
    OpReturnValue %result
    OpFunctionEnd
"#;

#[test]
fn libraries_export_to_a_linker() -> Outcome {
    let folder = folder("link")?;
    let path = |name: &str| folder.join(name).to_str().map(str::to_owned).ok_or("the folder is no UTF-8");
    let [text, caller, library, linked] = ["caller.spvasm", "caller.spv", "library.spv", "linked.spv"].map(path);
    let (text, caller, library, linked) = (text?, caller?, library?, linked?);
    fs::write(&text, CALLER)?;
    accepted("spirv-as", &["--target-env", "spv1.3", "-o", &caller], text.as_ref())?;
    let Some((_, module, _)) = modules()?.iter().find(|(name, _, _)| *name == "terrain_exact") else {
        return Err("there is no scene `terrain_exact`".into());
    };
    fs::write(&library, words(&module.spirv()?))?;
    // Every import must find an export.
    let options = ["--create-library", "--target-env", "spv1.3", "-o", &linked, &caller];
    accepted("spirv-link", &options, library.as_ref())?;
    accepted("spirv-val", &["--target-env", "spv1.3"], linked.as_ref())
}

#[test]
fn glsl_is_valid_for_webgl_and_desktops() -> Outcome {
    let folder = folder("glsl")?;
    for (name, _, [fragment, compute]) in modules()? {
        for (shader, version, es, extension) in [
            (fragment, 300, true, "frag"),
            (compute, 310, true, "comp"),
            (fragment, 450, false, "frag"),
            (compute, 450, false, "comp"),
        ] {
            let file = folder.join(format!("{name}.{version}.{extension}"));
            fs::write(&file, shader.glsl("main", version, es)?)?;
            accepted("glslangValidator", &[], &file)?;
        }
    }
    Ok(())
}

#[test]
fn hlsl_and_msl_are_written_whole() -> Outcome {
    for (name, module, shaders) in modules()? {
        for shader in shaders {
            for text in [shader.hlsl()?, shader.msl()?] {
                assert!(module.exports().iter().all(|export| text.contains(&export.name)), "{name}");
            }
        }
    }
    Ok(())
}

/// Two textures behind one sampler, which no scene has.
#[test]
fn slopes_read_in_every_language() -> Outcome {
    let folder = folder("slopes")?;
    let text = "@group(0) @binding(0) var slopes: texture_2d<f32>;
        @group(0) @binding(1) var slopes_cross: texture_2d<f32>;
        @group(0) @binding(2) var slopes_sampler: sampler;
        @fragment fn main(@location(0) position: vec2f) -> @location(0) vec4f {
            let read = slope_moments_read(slopes, slopes_cross, slopes_sampler, position, vec3f(2.0, 0.0, 2.0));
            return vec4f(read.mean.x + read.mean.y, read.covariance);
        }";
    let shader = prefilter::link(&[], text)?;
    let file = folder.join("slopes.spv");
    fs::write(&file, words(&shader.spirv()?))?;
    accepted("spirv-val", &["--target-env", "vulkan1.1"], &file)?;
    for (version, es) in [(300, true), (450, false)] {
        let file = folder.join(format!("slopes.{version}.frag"));
        fs::write(&file, shader.glsl("main", version, es)?)?;
        accepted("glslangValidator", &[], &file)?;
    }
    assert!([shader.hlsl()?, shader.msl()?].iter().all(|text| text.contains("slope_moments_read")));
    Ok(())
}

#[test]
fn what_a_language_lacks_is_an_error() -> Outcome {
    let (_, _, [fragment, compute]) = &modules()?[0];
    assert!(fragment
        .glsl("nobody", 450, false)
        .is_err_and(|error| error.to_string().contains("the shader has `main`")));
    assert!(fragment.glsl("main", 123, false).is_err());
    assert!(compute.glsl("main", 300, true).is_err());
    Ok(())
}
