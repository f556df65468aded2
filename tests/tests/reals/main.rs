//! The exact real line against oracles by other algorithms.
//!
//! | module | states laws of | oracle |
//! |---|---|---|
//! | `roots` | isolation, enclosures, Bernstein forms | Sturm's theorem |
//! | `order` | order, equality and signs of real algebraic numbers | squaring of surds, Sturm-Tarski |
//! | `forms` | exact and decimal forms | reading the text back |
//! | `regions` | unions of intervals | sets of cells between fixed numbers |
//! | `points` | signs at points of the plane | squaring of nested surds |
//! | `systems` | common zeros, curves without real points | Cramer's rule, substitution and Sturm |
//!
//! `generate` makes the input.

mod forms;
mod generate;
mod order;
mod points;
mod regions;
mod roots;
mod systems;
