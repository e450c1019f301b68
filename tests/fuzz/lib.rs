//! The operations of `tests/mutate`, fed with bytes: what the mutating runner does on the stable
//! toolchain, libFuzzer does here guided by coverage.

#[path = "../mutate/case.rs"]
mod case;
#[path = "../mutate/integers.rs"]
mod integers;
#[path = "../mutate/operations/mod.rs"]
#[expect(dead_code, reason = "new cases are libFuzzer's, and the fault to find is the runner's")]
mod operations;
#[path = "../support/random.rs"]
#[expect(dead_code, reason = "cases come from bytes")]
mod random;

/// Reads the bytes as a case of the operation and panics, with the case as code, if the answer is wrong.
pub fn check(name: &str, data: &[u8]) {
    let operation = operations::ALL.iter().find(|operation| operation.name == name);
    let operation = operation.unwrap_or_else(|| panic!("no operation {name}"));
    let words: Vec<u32> =
        data.chunks_exact(4).map(|word| u32::from_le_bytes([word[0], word[1], word[2], word[3]])).collect();
    if let Err(what) = (operation.check)(&words) {
        panic!("{}\n// {what}", (operation.code)(&words));
    }
}
