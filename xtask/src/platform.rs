//! What the machine is, where it keeps Vulkan's drivers, and how it installs packages.

use std::path::{Path, PathBuf};
use std::process::Command;

use crate::demand::Demand;

/// A family of machines that install packages by the same command.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Platform {
    /// Debian, Ubuntu and their relatives; `root` where the command may install without asking.
    Debian {
        /// Whether this process may install packages.
        root: bool,
    },
    /// Fedora and its relatives.
    Fedora,
    /// Arch Linux and its relatives.
    Arch,
    /// macOS.
    Mac,
    /// Windows.
    Windows,
    /// Anything else.
    Other,
}

impl Platform {
    /// The machine that this runs on.
    pub fn current() -> Self {
        if cfg!(target_os = "macos") {
            return Self::Mac;
        }
        if cfg!(windows) {
            return Self::Windows;
        }
        let release = std::fs::read_to_string("/etc/os-release").unwrap_or_default();
        Self::of_release(&release, is_root())
    }

    /// The platform that an `os-release` file names by `ID` or `ID_LIKE`.
    fn of_release(release: &str, root: bool) -> Self {
        let values = release.lines().filter_map(|line| line.strip_prefix("ID=").or(line.strip_prefix("ID_LIKE=")));
        let names: Vec<&str> = values.flat_map(|value| value.trim_matches('"').split_whitespace()).collect();
        let is = |family: &str| names.contains(&family);
        match () {
            () if is("debian") || is("ubuntu") => Self::Debian { root },
            () if is("fedora") => Self::Fedora,
            () if is("arch") => Self::Arch,
            () => Self::Other,
        }
    }

    /// Whether packages are ours to install: as root on Debian and Ubuntu, which is what containers and CI are.
    pub fn installs_by_itself(self) -> bool {
        self == Self::Debian { root: true }
    }

    /// The packages that meet the demands here.
    pub fn packages(self, demands: &[Demand]) -> Vec<&'static str> {
        demands.iter().flat_map(|&demand| self.packages_of(demand)).copied().collect()
    }

    fn packages_of(self, demand: Demand) -> &'static [&'static str] {
        match (self, demand) {
            (Self::Debian { .. }, Demand::Vulkan) => &["mesa-vulkan-drivers", "libvulkan1"],
            (Self::Fedora, Demand::Vulkan) => &["mesa-vulkan-drivers", "vulkan-loader"],
            (Self::Arch, Demand::Vulkan) => &["vulkan-swrast", "vulkan-icd-loader"],
            (Self::Mac, Demand::Vulkan) => &["molten-vk", "vulkan-loader"],
            (_, Demand::Vulkan) => &["Mesa's Vulkan drivers (lavapipe)", "the Vulkan loader"],
            (_, Demand::SpirvTools) => &["spirv-tools"],
            (Self::Debian { .. }, Demand::Glslang) => &["glslang-tools"],
            (_, Demand::Glslang) => &["glslang"],
            (Self::Mac, Demand::Node) => &["node"],
            (_, Demand::Node) => &["nodejs"],
            (Self::Mac, Demand::Npm) => &[],
            (Self::Fedora, Demand::Npm) => &["nodejs-npm"],
            (_, Demand::Npm) => &["npm"],
        }
    }

    /// The one command, or the one sentence, that meets the demands here.
    pub fn instruction(self, demands: &[Demand]) -> String {
        let packages = self.packages(demands).join(" ");
        match self {
            Self::Debian { .. } => format!("Run: sudo apt-get install -y --no-install-recommends {packages}"),
            Self::Fedora => format!("Run: sudo dnf install -y {packages}"),
            Self::Arch => format!("Run: sudo pacman -S --needed {packages}"),
            Self::Mac => format!("Run: brew install {packages} (MoltenVK is Vulkan on Metal)"),
            Self::Windows => {
                "Install the graphics card's driver, which brings Vulkan (or a build of Mesa's lavapipe), the \
                 Vulkan SDK for spirv-val and glslangValidator, and Node.js"
                    .to_owned()
            }
            Self::Other => format!("Install {}", self.packages(demands).join(", ")),
        }
    }

    /// Whether there is a Vulkan loader with at least one driver. Whether the driver finds a device only the driver
    /// knows: `cargo run -p spirv-tests --bin device` asks it.
    pub fn has_vulkan() -> bool {
        if cfg!(windows) {
            let windows = std::env::var_os("SystemRoot").map(PathBuf::from).unwrap_or_default();
            return windows.join("System32").join("vulkan-1.dll").exists();
        }
        has_loader() && has_driver()
    }
}

fn is_root() -> bool {
    Command::new("id").arg("-u").output().is_ok_and(|output| output.stdout.trim_ascii() == b"0")
}

fn has_loader() -> bool {
    let names =
        if cfg!(target_os = "macos") { ["libvulkan.1.dylib", "libMoltenVK.dylib"] } else { ["libvulkan.so.1"; 2] };
    let paths = std::env::var_os("LD_LIBRARY_PATH").unwrap_or_default();
    let multiarch = format!("/usr/lib/{}-linux-gnu", std::env::consts::ARCH);
    let standard = ["/usr/lib", "/usr/lib64", "/lib64", "/usr/local/lib", "/opt/homebrew/lib", &multiarch];
    let folders = standard.iter().map(PathBuf::from).chain(std::env::split_paths(&paths));
    folders.into_iter().any(|folder| names.iter().any(|name| folder.join(name).exists()))
}

fn has_driver() -> bool {
    if let Some(named) = std::env::var_os("VK_DRIVER_FILES").or_else(|| std::env::var_os("VK_ICD_FILENAMES")) {
        return std::env::split_paths(&named).any(|path| path.exists());
    }
    let standard =
        ["/usr/share", "/usr/local/share", "/etc", "/usr/local/etc", "/opt/homebrew/share", "/opt/homebrew/etc"];
    standard.iter().any(|folder| has_manifest(&Path::new(folder).join("vulkan/icd.d")))
}

/// Whether a folder holds the manifest of a driver.
fn has_manifest(folder: &Path) -> bool {
    let Ok(entries) = std::fs::read_dir(folder) else { return false };
    entries.flatten().any(|entry| entry.path().extension().is_some_and(|extension| extension == "json"))
}

#[cfg(test)]
mod tests {
    use super::*;

    const ALL: [Demand; 5] = [Demand::Vulkan, Demand::SpirvTools, Demand::Glslang, Demand::Node, Demand::Npm];

    #[test]
    fn release_files_name_their_family() {
        let platform = |release| Platform::of_release(release, true);
        assert_eq!(platform("PRETTY_NAME=\"Debian\"\nID=debian\n"), Platform::Debian { root: true });
        assert_eq!(platform("ID=linuxmint\nID_LIKE=\"ubuntu debian\"\n"), Platform::Debian { root: true });
        assert_eq!(platform("ID=rocky\nID_LIKE=\"rhel centos fedora\"\n"), Platform::Fedora);
        assert_eq!(platform("ID=arch\n"), Platform::Arch);
        assert_eq!(platform("VERSION_ID=debian\n"), Platform::Other);
    }

    #[test]
    fn only_root_on_debian_installs() {
        assert!(Platform::Debian { root: true }.installs_by_itself());
        for platform in [Platform::Debian { root: false }, Platform::Fedora, Platform::Arch, Platform::Mac] {
            assert!(!platform.installs_by_itself());
        }
    }

    #[test]
    fn every_platform_gets_one_line() {
        let debian = Platform::Debian { root: false }.instruction(&ALL);
        assert_eq!(
            debian,
            "Run: sudo apt-get install -y --no-install-recommends mesa-vulkan-drivers libvulkan1 spirv-tools \
             glslang-tools nodejs npm"
        );
        for platform in [Platform::Fedora, Platform::Arch, Platform::Mac, Platform::Windows, Platform::Other] {
            let line = platform.instruction(&ALL);
            assert!(!line.contains('\n') && line.len() > 20, "{line}");
        }
    }

    #[test]
    fn a_folder_without_manifests_is_no_driver() {
        assert!(!has_manifest(Path::new(env!("CARGO_MANIFEST_DIR"))));
        assert!(!has_manifest(Path::new("no/such/folder")));
    }
}
