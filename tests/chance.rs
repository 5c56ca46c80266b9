//! Values made by chance, the same in every run.

use proptest::test_runner::Config;
use proptest::test_runner::RngSeed;

/// A run of `cases`, always the same; it writes no file.
pub fn config(cases: u32) -> Config {
    Config { cases, rng_seed: RngSeed::Fixed(0), failure_persistence: None, ..Config::default() }
}
