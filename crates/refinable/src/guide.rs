//! The guide: short chapters, in which every example is compiled and run, and every transcript of the command
//! line is compared with what the program prints.
//!
//! 1. [`masks`]: the notation, and the conventions of others
//! 2. [`degree`]: degrees of polynomials, and why they are strata
//! 3. [`smoothness`]: norms, the joint spectral radius, ranges proved from both sides
//! 4. [`proof`]: one claim of a paper, from theorem to function to certificate to checker
//! 5. [`drawing`]: curves, surfaces, interproximate refinement
//! 6. [`symbols`]: the letters of Hameed and Mustafa's paper, and our names
//! 7. [`auditing`]: a paper of your own
//!
//! The same chapters can be read as Markdown in `crates/refinable/src/guide`; a gallery of pictures, each with
//! its command, is `docs/gallery/README.md`.

pub mod masks {
    #![doc = include_str!("guide/masks.md")]
}

pub mod degree {
    #![doc = include_str!("guide/degree.md")]
}

pub mod smoothness {
    #![doc = include_str!("guide/smoothness.md")]
}

pub mod proof {
    #![doc = include_str!("guide/proof.md")]
}

pub mod drawing {
    #![doc = include_str!("guide/drawing.md")]
}

pub mod symbols {
    #![doc = include_str!("guide/symbols.md")]
}

pub mod auditing {
    #![doc = include_str!("guide/auditing.md")]
}
