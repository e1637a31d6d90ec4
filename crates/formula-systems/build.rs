//! Sets the configuration `optimised` unless the crate is compiled without optimisation. "One way to inline" in
//! `docs/architecture.md` says what for.

fn main() {
    println!("cargo::rerun-if-changed=build.rs");
    println!("cargo::rustc-check-cfg=cfg(optimised)");
    if std::env::var("OPT_LEVEL").is_ok_and(|level| level != "0") {
        println!("cargo::rustc-cfg=optimised");
    }
}
