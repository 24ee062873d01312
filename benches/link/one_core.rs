//! Work on one core and the time that it takes: beside each other cores share memory, and each takes longer.

#[cfg(target_os = "linux")]
use rustix::thread::{sched_getaffinity, sched_getcpu, sched_setaffinity, CpuSet};
use rustix::time::{clock_gettime, ClockId};

/// What the work gives, with all threads that it starts on the core of this one, where the system lets them.
///
/// # Errors
/// What a system that has cores to choose refuses.
pub fn on_one_core<T>(work: impl FnOnce() -> T) -> std::io::Result<T> {
    #[cfg(target_os = "linux")]
    {
        let before = sched_getaffinity(None)?;
        let mut core = CpuSet::new();
        core.set(sched_getcpu());
        sched_setaffinity(None, &core)?;
        let given = work();
        sched_setaffinity(None, &before)?;
        Ok(given)
    }
    #[cfg(not(target_os = "linux"))]
    Ok(work())
}

/// Seconds that the process has taken of all cores.
pub fn processor() -> f64 {
    let time = clock_gettime(ClockId::ProcessCPUTime);
    time.tv_sec as f64 + 1e-9 * time.tv_nsec as f64
}
