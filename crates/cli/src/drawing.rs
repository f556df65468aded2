//! Curves, surfaces and basic limit functions: points in, points and pictures out.

use std::io::{self, Read};
use std::path::Path;

use refinable_algebra::Rational;
use refinable_analysis::interproximate_tensions;
use refinable_refine::{Coordinate, Ends, Net, PointTable, Polygon};
use refinable_report::{
    Assignment, Basis, Curve, CurveOptions, Document, Member, Mesh, MeshFormat, TensionTable,
    TensorSurface, assignment_document, choice_text, extrapolation, net_csv, net_json, polygon_csv,
    polygon_json, tensions_of,
};
use refinable_scheme::{Scheme, Substitution, tensor_factors};

use crate::arguments::{
    Closed, CurveArguments, EndsArgument, Format, InterproximateArguments, PointsArguments,
    SchemeArguments, SurfaceArguments,
};
use crate::commands::{resolve, resolve_text};
use crate::failure::Failure;
use crate::files::{self, Image};
use crate::output;

/// The most that is read from a file of points, in bytes.
const LARGEST_INPUT: u64 = 256 << 20;

/// What a file that is written holds, by the end of its name.
#[derive(Clone, Copy)]
enum Target {
    Picture(Image),
    Mesh(MeshFormat),
    Csv,
    Json,
}

impl Target {
    fn of(path: &Path, with_meshes: bool) -> Result<Target, Failure> {
        let end = path.extension().map(|end| end.to_string_lossy().to_lowercase());
        Ok(match end.as_deref() {
            Some("csv") => Target::Csv,
            Some("json") => Target::Json,
            Some("obj") if with_meshes => Target::Mesh(MeshFormat::Obj),
            Some("ply") if with_meshes => Target::Mesh(MeshFormat::Ply),
            Some("stl") if with_meshes => Target::Mesh(MeshFormat::Stl),
            Some("svg") => Target::Picture(Image::Svg),
            Some("png") => Target::Picture(Image::Png),
            _ => {
                let meshes = if with_meshes { ", .obj, .ply, .stl" } else { "" };
                let message = format!("{} does not tell a format", path.display());
                let hint = format!("end the name in .svg, .png, .csv, .json{meshes}");
                return Err(Failure::new("picture", message, hint));
            }
        })
    }
}

/// Where points go; `None` for standard output.
type Goal<'a> = Option<(&'a Path, Target)>;

fn goal(arguments: &PointsArguments, with_meshes: bool) -> Result<Goal<'_>, Failure> {
    let path = arguments.output.as_deref();
    path.map(|path| Ok((path, Target::of(path, with_meshes)?))).transpose()
}

/// Writes or prints points.
fn emit(
    goal: Goal<'_>,
    format: Format,
    csv: &dyn Fn() -> String,
    document: &dyn Fn() -> Document,
) -> Result<(), Failure> {
    match goal {
        Some((path, Target::Json)) => files::write_file(path, document().json_text().as_bytes()),
        Some((path, _)) => files::write_file(path, csv().as_bytes()),
        // On a terminal as well, points are there to be piped.
        None if matches!(format, Format::Text | Format::Csv) => output::print_text(&csv()),
        None => output::print(&document(), format),
    }
}

fn only_floats() -> Failure {
    let hint = "leave out --exact, or write .csv or .json";
    Failure::new("usage", "pictures and meshes are made in floats", hint)
}

/// `curve`.
///
/// # Errors
/// Anything wrong with the input; nothing has been written then.
pub fn curve(arguments: &CurveArguments) -> Result<(), Failure> {
    let goal = goal(&arguments.points, false)?;
    let format = arguments.points.format.format;
    let scheme = resolve(&arguments.scheme)?;
    let ends = ends(arguments.points.ends.unwrap_or(EndsArgument::Trim), &scheme);
    if arguments.exact {
        if matches!(goal, Some((_, Target::Picture(_)))) {
            return Err(only_floats());
        }
        let made = made_curve::<Rational>(arguments, &scheme, ends)?;
        return emit(goal, format, &|| made.csv(), &|| made.document());
    }
    let mut made = made_curve::<f64>(arguments, &scheme, ends)?;
    if arguments.comb {
        made = made.with_comb(&scheme, ends)?;
    }
    match goal {
        Some((path, Target::Picture(image))) => image.write(path, &made.picture()?),
        _ => emit(goal, format, &|| made.csv(), &|| made.document()),
    }
}

fn made_curve<T: Coordinate>(
    arguments: &CurveArguments,
    scheme: &Scheme,
    ends: Ends,
) -> Result<Curve<T>, Failure> {
    let polygon = polygon(read::<T>(&arguments.points.points)?, arguments.closed)?;
    let options = CurveOptions { levels: arguments.points.levels, ends, limit: arguments.limit };
    Ok(Curve::new(scheme, polygon, options)?)
}

/// `surface`.
///
/// # Errors
/// Anything wrong with the input; nothing has been written then.
pub fn surface(arguments: &SurfaceArguments) -> Result<(), Failure> {
    let goal = goal(&arguments.points, true)?;
    let format = arguments.points.format.format;
    if arguments.exact {
        if matches!(goal, Some((_, Target::Picture(_) | Target::Mesh(_)))) {
            return Err(only_floats());
        }
        let made = made_surface::<Rational>(arguments)?;
        return emit(goal, format, &|| made.csv(), &|| made.document());
    }
    let made = made_surface::<f64>(arguments)?;
    emit_surface(&made, goal, format)
}

fn emit_surface(made: &TensorSurface<f64>, goal: Goal<'_>, format: Format) -> Result<(), Failure> {
    match goal {
        Some((path, Target::Picture(image))) => image.write(path, &made.picture()?),
        Some((path, Target::Mesh(format))) => {
            let mesh = Mesh::new(made.points())?;
            files::write_with(path, &|out| mesh.write(format, out))
        }
        _ => emit(goal, format, &|| made.csv(), &|| made.document()),
    }
}

fn made_surface<T: Coordinate>(arguments: &SurfaceArguments) -> Result<TensorSurface<T>, Failure> {
    let [across, along] = factors(arguments)?;
    let net = net(read::<T>(&arguments.points.points)?, arguments.columns, arguments.closed)?;
    let ends = [&across, &along]
        .map(|scheme| ends(arguments.points.ends.unwrap_or(EndsArgument::Trim), scheme));
    let levels = arguments.points.levels;
    Ok(TensorSurface::new([&across, &along], net, levels, ends, arguments.limit)?)
}

/// The schemes from row to row and along the rows.
///
/// # Errors
/// Whatever is wrong with them; a direction that is given twice, or settings for one that is not.
pub fn factors(arguments: &SurfaceArguments) -> Result<[Scheme; 2], Failure> {
    let SchemeArguments { scheme: text, set, arity } = &arguments.scheme;
    let (across, along) = match (tensor_factors(text), &arguments.across) {
        (Some(factors), None) => factors.map(|[across, along]| (across, along))?,
        (Some(_), Some(_)) => {
            let message = "the scheme from row to row is given twice";
            return Err(Failure::new(
                "usage",
                message,
                "leave out --across, or the tensor product",
            ));
        }
        (None, Some(across)) => (across.as_str(), text.as_str()),
        (None, None) if !arguments.set_across.is_empty() => {
            let message = "--set-across sets parameters of a scheme that is not given";
            let hint = "say --across SCHEME, or 'tensor(S, T)'; --set is for both directions";
            return Err(Failure::new("usage", message, hint));
        }
        (None, None) => {
            let scheme = resolve(&arguments.scheme)?;
            return Ok([scheme.clone(), scheme]);
        }
    };
    Ok([resolve_text(across, *arity, &arguments.set_across)?, resolve_text(along, *arity, set)?])
}

/// `basis`.
///
/// # Errors
/// Anything wrong with the input; nothing has been written then.
pub fn basis(
    scheme: &Scheme,
    levels: u32,
    order: Option<usize>,
    path: Option<&Path>,
    format: Format,
) -> Result<(), Failure> {
    let target = path.map(|path| Ok::<_, Failure>((path, Target::of(path, false)?))).transpose()?;
    let made = Basis::new(scheme, levels, order)?;
    match target {
        Some((path, Target::Picture(image))) => image.write(path, &made.picture()?),
        Some((path, Target::Json)) => {
            files::write_file(path, made.document().json_text().as_bytes())
        }
        Some((path, _)) => files::write_file(path, made.document().csv().as_bytes()),
        None => output::print(&made.document(), format),
    }
}

/// `interproximate`.
///
/// # Errors
/// Anything wrong with the input; nothing has been written then.
pub fn interproximate(arguments: &InterproximateArguments) -> Result<(), Failure> {
    let points = &arguments.points;
    let goal = goal(points, arguments.surface)?;
    let family = resolve(&arguments.scheme)?;
    if tensions_of(&family).is_empty() {
        let hint = "take a family such as a3 or a5, or `refinable curve` for a single scheme";
        return Err(Failure::new("tensions", format!("{} has no tensions", family.name()), hint));
    }
    let table = TensionTable::new(&family, &read::<Rational>(&points.points)?)?;
    let assignment = assignment(arguments, &family, &table)?;
    // Trimmed ends would lose points that are to be interpolated.
    let ends = ends(points.ends.unwrap_or(EndsArgument::Reflect), &family);
    let table = in_floats(&table.points);
    let (name, levels) = (family.name(), points.levels);
    if arguments.surface {
        let control = net(table, arguments.columns, arguments.closed)?;
        let refined = assignment.refine_net(&family, &control, levels, [ends; 2])?;
        let made = TensorSurface::of_points(name, control, refined, levels);
        let document =
            || assignment_document(&family, &assignment, net_json(made.points()), levels);
        return match goal {
            Some((_, Target::Picture(_) | Target::Mesh(_))) => {
                emit_surface(&made, goal, points.format.format)
            }
            _ => emit_assigned(goal, points.format.format, &|| net_csv(made.points()), &document),
        };
    }
    let control = polygon(table, arguments.closed != Closed::Neither)?;
    let refined = assignment.refine(&family, &control, levels, ends)?;
    let marked = assignment.interpolated(&family)?;
    let made = Curve::of_points(name, control, refined, levels, marked);
    let document =
        || assignment_document(&family, &assignment, polygon_json(made.points()), levels);
    match goal {
        Some((path, Target::Picture(image))) => image.write(path, &made.picture()?),
        _ => emit_assigned(goal, points.format.format, &|| polygon_csv(made.points()), &document),
    }
}

/// On a terminal the tensions are of interest, in a CSV file the points.
fn emit_assigned(
    goal: Goal<'_>,
    format: Format,
    csv: &dyn Fn() -> String,
    document: &dyn Fn() -> Document,
) -> Result<(), Failure> {
    if goal.is_none() && format == Format::Text {
        return output::print(&document(), format);
    }
    emit(goal, format, csv, document)
}

fn assignment(
    arguments: &InterproximateArguments,
    family: &Scheme,
    table: &TensionTable,
) -> Result<Assignment, Failure> {
    let approximating = arguments.approximating.as_deref();
    let approximating = approximating.map(|text| member(family, text)).transpose()?;
    if let (Some(vertices), Some(edges)) = (&table.vertices, &table.edges) {
        if !arguments.interpolate.is_empty() {
            let hint = "leave out the columns, or leave out --interpolate";
            let message = "tensions are given by columns and by --interpolate";
            return Err(Failure::new("tensions", message, hint));
        }
        return Ok(Assignment::of_members(family, vertices, edges, approximating)?);
    }
    let interpolating = arguments.interpolating.as_deref();
    let interpolating = interpolating.map(|text| member(family, text)).transpose()?;
    let count = table.points.values.len() / table.points.dimension;
    Assignment::expect_points(count, &arguments.interpolate)?;
    let (interpolating, approximating) = match (interpolating, approximating) {
        (None, Some(approximating)) if arguments.interpolate.is_empty() => {
            (approximating.clone(), approximating)
        }
        (Some(interpolating), Some(approximating)) => (interpolating, approximating),
        (interpolating, approximating) => {
            // The search takes seconds: say so where somebody waits.
            output::say("choosing tensions …\n");
            let choice = interproximate_tensions(family.name(), family.mask())?;
            output::say(&format!("{}\n", choice_text(family, &choice)));
            (
                interpolating.unwrap_or(choice.interpolating),
                approximating.unwrap_or(choice.approximating),
            )
        }
    };
    let interpolated = &arguments.interpolate;
    let made = Assignment::of_vertices(count, interpolated, interpolating, approximating)?;
    if let Some(moved) = first_missing(interpolated, &made.interpolated(family)?) {
        let hint =
            "the vertex rule of the interpolating member must be the old point, as at alpha=0";
        let message = format!("these tensions do not interpolate control point {moved}");
        return Err(Failure::new("tensions", message, hint));
    }
    Ok(made)
}

/// The first number that is not in the list.
fn first_missing(numbers: &[usize], list: &[usize]) -> Option<usize> {
    numbers.iter().copied().find(|i| !list.contains(i))
}

/// `alpha=0,beta=-1/20`: one value for each parameter of the family.
///
/// # Errors
/// A text that does not give just one number for each.
pub fn member(family: &Scheme, text: &str) -> Result<Member, Failure> {
    let mut values = Vec::new();
    for part in text.split(',') {
        values.push(Substitution::parse(part)?);
    }
    let value = |parameter| {
        let mut own = values.iter().filter(|set| set.parameter() == parameter);
        own.next().and_then(|set| set.value().as_constant()).filter(|_| own.next().is_none())
    };
    let parameters = tensions_of(family);
    let member: Option<Member> = parameters.iter().map(value).collect();
    member.filter(|_| values.len() == parameters.len()).ok_or_else(|| {
        let names: Vec<String> = parameters.iter().map(|p| format!("{p}=…")).collect();
        let message = format!("`{text}` does not give a number for each parameter");
        Failure::new("tensions", message, format!("write '{}'", names.join(",")))
    })
}

fn ends(argument: EndsArgument, scheme: &Scheme) -> Ends {
    match argument {
        EndsArgument::Trim => Ends::Trim,
        EndsArgument::Reflect => Ends::Reflect,
        EndsArgument::Extrapolate => extrapolation(scheme),
    }
}

fn read<T: Coordinate>(path: &Path) -> Result<PointTable<T>, Failure> {
    let mut bytes = Vec::new();
    let failed = |error: io::Error| Failure::file(path, &error);
    if path == Path::new("-") {
        io::stdin().take(LARGEST_INPUT + 1).read_to_end(&mut bytes).map_err(failed)?;
    } else {
        let file = std::fs::File::open(path).map_err(failed)?;
        file.take(LARGEST_INPUT + 1).read_to_end(&mut bytes).map_err(failed)?;
    }
    if bytes.len() as u64 > LARGEST_INPUT {
        let hint = format!("{} MiB are the most", LARGEST_INPUT >> 20);
        return Err(Failure::new("points", "there are too many points", hint));
    }
    let text = String::from_utf8(bytes).map_err(|error| {
        let line =
            error.as_bytes()[..error.utf8_error().valid_up_to()].split(|b| *b == b'\n').count();
        let hint = "save the points as UTF-8 text";
        Failure::new("points", format!("line {line}: this is no text"), hint)
    })?;
    Ok(PointTable::parse(&text)?)
}

fn in_floats(table: &PointTable<Rational>) -> PointTable<f64> {
    PointTable {
        names: table.names.clone(),
        dimension: table.dimension,
        values: table.values.iter().map(f64::from_rational).collect(),
        rows: table.rows.clone(),
    }
}

fn polygon<T: Coordinate>(table: PointTable<T>, closed: bool) -> Result<Polygon<T>, Failure> {
    if table.rows.len() > 1 {
        let message = format!("the points make up {} rows", table.rows.len());
        let hint = "a polygon has no blank lines; a net is for `refinable surface`, or --surface";
        return Err(Failure::new("points", message, hint));
    }
    Ok(Polygon::new(table.dimension, table.values, closed)?)
}

fn net<T: Coordinate>(
    table: PointTable<T>,
    columns: Option<u32>,
    closed: Closed,
) -> Result<Net<T>, Failure> {
    let columns = match (columns, &table.rows[..]) {
        (Some(columns), [_]) => columns as usize,
        (None, [_]) => {
            let hint = "put a blank line between the rows of the net, or say --columns N";
            return Err(Failure::new("points", "the points make up a single row", hint));
        }
        (Some(columns), rows) if rows.iter().any(|n| *n != columns as usize) => {
            let message = format!("blank lines or brackets make rows of {}", rows[0]);
            let hint = "leave out --columns, or the blank lines";
            return Err(Failure::new("points", message, hint));
        }
        (_, rows) => {
            if let Some(k) = rows.iter().position(|n| *n != rows[0]) {
                let message =
                    format!("row {} has {} points, row 1 has {}", k + 1, rows[k], rows[0]);
                return Err(Failure::new("points", message, "all rows of a net are as long"));
            }
            rows[0]
        }
    };
    let across = matches!(closed, Closed::Columns | Closed::Both);
    let along = matches!(closed, Closed::Rows | Closed::Both);
    Ok(Net::new(table.dimension, columns, table.values, [across, along])?)
}
