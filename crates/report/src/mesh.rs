//! Surfaces as meshes: OBJ, PLY and STL.

use std::io::{self, Write};

use refinable_refine::{ACROSS, ALONG, Net};
use refinable_scheme::Diagnostic;

/// A refined net as a mesh of quadrilaterals, counter-clockwise where the rows go up and the columns to
/// the right.
pub struct Mesh<'a> {
    net: &'a Net<f64>,
}

/// The formats of meshes.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum MeshFormat {
    /// Wavefront OBJ: text, quadrilaterals.
    Obj,
    /// PLY: binary, little-endian, doubles, quadrilaterals.
    Ply,
    /// STL: binary, single precision, two triangles for each quadrilateral.
    Stl,
}

impl<'a> Mesh<'a> {
    /// The mesh of a net; points of two coordinates lie in the plane `z = 0`.
    ///
    /// # Errors
    /// Code `mesh` if the points have another number of coordinates, if there are no faces, or more than
    /// the formats can count.
    pub fn new(net: &'a Net<f64>) -> Result<Self, Diagnostic> {
        let mesh = Mesh { net };
        let problem = if !(2..=3).contains(&net.dimension()) {
            Some((format!("points have {} coordinates", net.dimension()), "a mesh has 2 or 3"))
        } else if mesh.count() == 0 {
            let hint =
                "a mesh has two rows and two columns at least; open ones lose some at their ends";
            Some(("there are no faces".into(), hint))
        } else if mesh.count() > u64::from(u32::MAX / 2) {
            Some((format!("there are {} faces", mesh.count()), "ask for fewer levels"))
        } else {
            None
        };
        match problem {
            Some((message, hint)) => Err(Diagnostic::new("mesh", message).with_hint(hint)),
            None => Ok(mesh),
        }
    }

    fn count(&self) -> u64 {
        let [rows, columns] = faces(self.net);
        rows as u64 * columns as u64
    }

    fn vertices(&self) -> impl Iterator<Item = [f64; 3]> + '_ {
        self.net.values().chunks_exact(self.net.dimension()).map(in_space)
    }

    /// Writes the mesh.
    ///
    /// # Errors
    /// Those of `out`.
    pub fn write(&self, format: MeshFormat, out: &mut dyn Write) -> io::Result<()> {
        match format {
            MeshFormat::Obj => self.write_obj(out),
            MeshFormat::Ply => self.write_ply(out),
            MeshFormat::Stl => self.write_stl(out),
        }
    }

    fn write_obj(&self, out: &mut dyn Write) -> io::Result<()> {
        for [x, y, z] in self.vertices() {
            writeln!(out, "v {x} {y} {z}")?;
        }
        for corners in quadrilaterals(self.net) {
            let [a, b, c, d] = corners.map(|k| k + 1);
            writeln!(out, "f {a} {b} {c} {d}")?;
        }
        Ok(())
    }

    fn write_ply(&self, out: &mut dyn Write) -> io::Result<()> {
        let (vertices, faces) = (self.net.rows() * self.net.columns(), self.count());
        write!(
            out,
            "ply\nformat binary_little_endian 1.0\nelement vertex {vertices}\nproperty double x\n\
             property double y\nproperty double z\nelement face {faces}\n\
             property list uchar uint vertex_indices\nend_header\n"
        )?;
        for x in self.vertices().flatten() {
            out.write_all(&x.to_le_bytes())?;
        }
        for corners in quadrilaterals(self.net) {
            out.write_all(&[4])?;
            for k in corners {
                out.write_all(&(k as u32).to_le_bytes())?;
            }
        }
        Ok(())
    }

    fn write_stl(&self, out: &mut dyn Write) -> io::Result<()> {
        out.write_all(&[0; 80])?;
        out.write_all(&(2 * self.count() as u32).to_le_bytes())?;
        let width = self.net.dimension();
        let vertex = |k: usize| in_space(&self.net.values()[k * width..][..width]);
        for [a, b, c, d] in quadrilaterals(self.net) {
            for triangle in [[a, b, c], [a, c, d]] {
                let corners = triangle.map(vertex);
                let numbers = [unit_normal(corners)].into_iter().chain(corners).flatten();
                for x in numbers {
                    out.write_all(&(x as f32).to_le_bytes())?;
                }
                out.write_all(&[0; 2])?;
            }
        }
        Ok(())
    }
}

/// Rows and columns of faces.
fn faces(net: &Net<f64>) -> [usize; 2] {
    let closed = net.closed();
    // Two rows that are joined at both sides would make every face twice.
    let count = |n: usize, closed: bool| if closed && n > 2 { n } else { n - 1 };
    [count(net.rows(), closed[ACROSS]), count(net.columns(), closed[ALONG])]
}

/// Corners of the quadrilaterals, as indices of vertices from 0, row by row.
pub(crate) fn quadrilaterals(net: &Net<f64>) -> impl Iterator<Item = [usize; 4]> + '_ {
    let [rows, columns] = faces(net);
    let (n, m) = (net.rows(), net.columns());
    let index = move |i: usize, j: usize| (i % n) * m + j % m;
    let face = move |i, j| [index(i, j), index(i, j + 1), index(i + 1, j + 1), index(i + 1, j)];
    (0..rows).flat_map(move |i| (0..columns).map(move |j| face(i, j)))
}

/// A point of two or three coordinates in space.
pub(crate) fn in_space(point: &[f64]) -> [f64; 3] {
    [point[0], point[1], point.get(2).copied().unwrap_or(0.0)]
}

/// The normal of a triangle on the side from which it is counter-clockwise; zero if it has no area.
fn unit_normal([a, b, c]: [[f64; 3]; 3]) -> [f64; 3] {
    let normal = cross(difference(b, a), difference(c, a));
    let length = dot(normal, normal).sqrt();
    if length > 0.0 { normal.map(|x| x / length) } else { [0.0; 3] }
}

pub(crate) fn difference(a: [f64; 3], b: [f64; 3]) -> [f64; 3] {
    [a[0] - b[0], a[1] - b[1], a[2] - b[2]]
}

pub(crate) fn cross(a: [f64; 3], b: [f64; 3]) -> [f64; 3] {
    [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]]
}

pub(crate) fn dot(a: [f64; 3], b: [f64; 3]) -> f64 {
    a[0] * b[0] + a[1] * b[1] + a[2] * b[2]
}
