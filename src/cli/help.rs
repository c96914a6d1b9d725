//! `completions` and `man`: what helps to type the command, made from its own description.

use clap::CommandFactory;

use super::args::{Args, Completions, Man};
use super::out::{say, sayln};
use crate::error::{Error, Result, Stage};
use crate::run::RunFolder;

/// `completions`: a script for the shell, on standard output.
pub fn completions(args: &Completions) -> Result<u8> {
    let mut text = Vec::new();
    clap_complete::generate(args.shell, &mut Args::command(), "bladewright", &mut text);
    say!("{}", String::from_utf8_lossy(&text));
    Ok(0)
}

/// `man`: one page for the command and one for each verb.
pub fn man(args: &Man) -> Result<u8> {
    let mut folder = RunFolder::begin(&args.out)?;
    let mut command = Args::command();
    command.build();
    let mut pages = vec![("bladewright".to_owned(), command.clone())];
    for verb in command.get_subcommands().filter(|v| v.get_name() != "help") {
        let name = format!("bladewright-{}", verb.get_name());
        pages.push((name.clone(), verb.clone().name(name)));
    }
    for (name, command) in pages {
        let mut text = Vec::new();
        clap_mangen::Man::new(command)
            .render(&mut text)
            .map_err(|e| Error::io(Stage::Output, format!("the page {name}.1 cannot be written: {e}")).caused_by(e))?;
        folder.add(&format!("{name}.1"), text)?;
    }
    for file in folder.finish()? {
        sayln!("{}", file.display());
    }
    Ok(0)
}
