//! Meshes as programs of others read them.

use std::collections::BTreeSet;
use std::io::Cursor;

use ply_rs_bw::parser::Parser;
use ply_rs_bw::ply::{DefaultElement, Property};
use refinable_refine::{Ends, Net, Weights, refine_net};
use refinable_report::{Mesh, MeshFormat, net_csv};
use refinable_scheme::Scheme;

/// A refined net whose points are all different.
fn net(closed: [bool; 2]) -> Net<f64> {
    let point = |i: usize, j: usize| {
        let (i, j) = (i as f64, j as f64);
        [i * i - j / 3.0, j * 1.5 + i * j, i - j * j / 7.0]
    };
    let values = (0..4).flat_map(|i| (0..5).flat_map(move |j| point(i, j))).collect();
    let control = Net::new(3, 5, values, closed).unwrap();
    let rule = Weights::new(Scheme::resolve("dd4", 2).unwrap().mask()).unwrap();
    refine_net(&control, [&[&rule], &[&rule]], [Ends::Reflect; 2]).unwrap()
}

fn written(net: &Net<f64>, format: MeshFormat) -> Vec<u8> {
    let mut bytes = Vec::new();
    Mesh::new(net).unwrap().write(format, &mut bytes).unwrap();
    bytes
}

const CLOSED: [[bool; 2]; 4] = [[false, false], [true, false], [false, true], [true, true]];

/// Faces that are not repeated, and meet along edges that run in opposite directions: oriented. The edges that
/// belong to one face only are the boundary, and there are as many as the net has.
fn check_faces(faces: &[Vec<usize>], net: &Net<f64>, closed: [bool; 2]) {
    let mut seen = BTreeSet::new();
    let mut edges = BTreeSet::new();
    for face in faces {
        let corners: BTreeSet<usize> = face.iter().copied().collect();
        assert_eq!(corners.len(), face.len(), "a corner twice");
        assert!(seen.insert(corners), "a face twice");
        for (k, a) in face.iter().enumerate() {
            let b = face[(k + 1) % face.len()];
            assert!(edges.insert((*a, b)), "two faces run along an edge the same way");
        }
    }
    let boundary = edges.iter().filter(|(a, b)| !edges.contains(&(*b, *a))).count();
    let [rows, columns] = [net.rows(), net.columns()];
    let along = if closed[0] { 0 } else { 2 * (if closed[1] { columns } else { columns - 1 }) };
    let across = if closed[1] { 0 } else { 2 * (if closed[0] { rows } else { rows - 1 }) };
    assert_eq!(boundary, along + across);
    // Euler's number of a disk, a cylinder (twice) and a torus.
    let inner = edges.len() - boundary;
    let euler = (rows * columns) as i64 - (boundary + inner / 2) as i64 + faces.len() as i64;
    assert_eq!(euler, i64::from(closed == [false, false]));
}

#[test]
fn obj_is_read_back() {
    for closed in CLOSED {
        let net = net(closed);
        let bytes = written(&net, MeshFormat::Obj);
        let options = tobj::LoadOptions::default();
        let none = |_: &std::path::Path| Ok((Vec::new(), Default::default()));
        let (models, _) = tobj::load_obj_buf(&mut Cursor::new(bytes), &options, none).unwrap();
        let [model] = &models[..] else { panic!("one model") };
        let mesh = &model.mesh;
        assert!(mesh.face_arities.iter().all(|n| *n == 4));
        let floats: Vec<f32> = net.values().iter().map(|x| *x as f32).collect();
        // The reader numbers vertices in the order of their first use.
        let faces: Vec<Vec<usize>> =
            mesh.indices.chunks(4).map(|f| f.iter().map(|i| *i as usize).collect()).collect();
        check_faces(&faces, &net, closed);
        let places = |values: &[f32]| -> BTreeSet<[u32; 3]> {
            values.chunks(3).map(|p| [p[0].to_bits(), p[1].to_bits(), p[2].to_bits()]).collect()
        };
        assert_eq!(places(&mesh.positions), places(&floats));
    }
}

#[test]
fn ply_is_read_back() {
    for closed in CLOSED {
        let net = net(closed);
        let bytes = written(&net, MeshFormat::Ply);
        let ply = Parser::<DefaultElement>::new().read_ply(&mut Cursor::new(bytes)).unwrap();
        let number = |property: &Property| match property {
            Property::Double(x) => *x,
            other => panic!("{other:?}"),
        };
        let values =
            ply.payload["vertex"].iter().flat_map(|v| ["x", "y", "z"].map(|k| number(&v[k])));
        assert_eq!(values.collect::<Vec<f64>>(), net.values());
        let indices = |face: &DefaultElement| match &face["vertex_indices"] {
            Property::ListUInt(list) => list.iter().map(|i| *i as usize).collect(),
            other => panic!("{other:?}"),
        };
        let faces: Vec<Vec<usize>> = ply.payload["face"].iter().map(indices).collect();
        check_faces(&faces, &net, closed);
    }
}

#[test]
fn stl_is_read_back() {
    for closed in CLOSED {
        let net = net(closed);
        let bytes = written(&net, MeshFormat::Stl);
        let mesh = stl_io::read_stl(&mut Cursor::new(bytes)).unwrap();
        let faces: Vec<Vec<usize>> = mesh.faces.iter().map(|f| f.vertices.to_vec()).collect();
        check_faces(&faces, &net, closed);
        for face in &mesh.faces {
            let [a, b, c] = face.vertices.map(|k| {
                let v = mesh.vertices[k];
                [f64::from(v[0]), f64::from(v[1]), f64::from(v[2])]
            });
            let [u, v] = [b, c].map(|p| [p[0] - a[0], p[1] - a[1], p[2] - a[2]]);
            let normal =
                [u[1] * v[2] - u[2] * v[1], u[2] * v[0] - u[0] * v[2], u[0] * v[1] - u[1] * v[0]];
            let length = normal.iter().map(|x| x * x).sum::<f64>().sqrt();
            let written = [0, 1, 2].map(|k| f64::from(face.normal[k]));
            assert!(normal.iter().zip(written).all(|(x, y)| (x / length - y).abs() < 1e-3));
        }
    }
}

/// What is too small or of another dimension is no mesh; two closed rows make faces once.
#[test]
fn what_is_no_mesh() {
    let code = |dimension, columns, count: usize, closed| {
        let net =
            Net::new(dimension, columns, (0..count).map(|i| i as f64).collect(), closed).unwrap();
        Mesh::new(&net).err().map(|error| error.code())
    };
    assert_eq!(code(1, 2, 4, [false; 2]), Some("mesh"));
    assert_eq!(code(4, 2, 16, [false; 2]), Some("mesh"));
    assert_eq!(code(3, 1, 6, [false; 2]), Some("mesh"));
    assert_eq!(code(3, 2, 6, [true; 2]), Some("mesh"));
    assert_eq!(code(2, 2, 8, [true; 2]), None);
    let net = Net::new(2, 2, (0..8).map(f64::from).collect(), [true; 2]).unwrap();
    let text = String::from_utf8(written(&net, MeshFormat::Obj)).unwrap();
    assert_eq!(text, "v 0 1 0\nv 2 3 0\nv 4 5 0\nv 6 7 0\nf 1 2 4 3\n");
    assert_eq!(net_csv(&net), "x,y\n0,1\n2,3\n\n4,5\n6,7\n");
}
