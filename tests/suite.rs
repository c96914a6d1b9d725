//! The tests from outside, one program: the command, plans in memory, the files of the repository.
//! Each file beside this one is a module; those that need the same helpers share them.

mod families;
mod of_prism;

mod batch;
mod batch_kill;
mod channel_cli;
mod cli;
mod closed_forms;
mod compare;
mod corner;
mod corpus;
mod corpus_edges;
mod corpus_open;
mod corpus_table;
mod faults_cli;
mod folder;
mod foreign;
mod fuzz_short;
mod hostile;
mod in_memory;
mod layering;
mod manual;
mod mesh_and_step;
mod models_readme;
mod pinch;
mod pinch_audit;
mod prism;
mod recognise;
mod tamper;
mod terminal;
mod turning;
mod walls;
mod wheel;
mod words;
