//! Memory of the running process.

/// Peak resident memory of the process [bytes], where the system tells (Linux: `VmHWM` of /proc/self/status).
pub fn peak() -> Option<u64> {
    let status = std::fs::read_to_string("/proc/self/status").ok()?;
    let line = status.lines().find(|l| l.starts_with("VmHWM:"))?;
    line.split_whitespace().nth(1)?.parse::<u64>().ok().map(|kib| kib * 1024)
}
