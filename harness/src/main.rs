//! The `millpond` program. `millpond help` lists its commands.
use clap::Parser as _;
use millpond::cli::Cli;
use std::process::ExitCode;

fn main() -> ExitCode {
    match Cli::parse().execute() {
        Ok(kept) => ExitCode::from(u8::from(!kept)),
        Err(failure) => {
            eprintln!("millpond: {failure}");
            ExitCode::from(failure.exit_status())
        }
    }
}
