//! Banded linear systems.
