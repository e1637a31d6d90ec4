//! The formats CSV, npz and Parquet: they hold the same numbers, and the configuration that made them.

use crate::program::{Folder, numbers};
use parquet::basic::{Compression, Encoding};
use parquet::file::reader::{FileReader, SerializedFileReader};
use parquet::file::statistics::Statistics;
use parquet::record::RowAccessor;
use std::collections::BTreeMap;
use std::fs::File;
use std::io::Read;

const CONFIGURATION: &str =
    "[integrator]\nscheme = 'gauss-4'\nend = 4\n[output]\nevery = 3\nattitude = true\n";

/// The methods with an attitude, one for each way to compute it.
const METHODS: [(&str, &str); 5] = [
    ("collective", "gauss-4"),
    ("collective", "kahan-li-6"),
    ("reduced", "implicit-midpoint"),
    ("reduced", "gauss-8"),
    ("splitting", "strang"),
];

/// Returns the configuration with another method.
fn by(formulation: &str, scheme: &str) -> String {
    let method = format!("formulation = '{formulation}'\nscheme = '{scheme}'");
    CONFIGURATION.replace("scheme = 'gauss-4'", &method)
}

/// Returns a folder with the same run in the three formats, and its table.
fn written(configuration: &str) -> (Folder, Vec<String>, Vec<Vec<f64>>) {
    let folder = Folder::new();
    folder.write("a.toml", configuration);
    for out in ["a.csv", "a.npz", "a.parquet"] {
        let run = folder.heavytop(&["simulate", "a.toml", "--out", out]);
        assert_eq!((run.code(), run.complaints()), (0, String::new()), "{out}");
    }
    assert_eq!(folder.names(), ["a.csv", "a.npz", "a.parquet", "a.toml"]);
    let (header, rows) = numbers(&folder.read("a.csv"));
    (folder, header, rows)
}

/// Reads the arrays of an npz file: their headers, and their bytes.
fn arrays(folder: &Folder, name: &str) -> BTreeMap<String, (String, Vec<u8>)> {
    let mut archive = zip::ZipArchive::new(File::open(folder.path(name)).unwrap()).unwrap();
    let count = archive.len();
    let read = |i| {
        let mut entry = archive.by_index(i).unwrap();
        let mut bytes = Vec::new();
        entry.read_to_end(&mut bytes).unwrap();
        assert_eq!(&bytes[..8], b"\x93NUMPY\x01\x00");
        let start = 10 + usize::from(u16::from_le_bytes([bytes[8], bytes[9]]));
        assert!(start % 64 == 0 && bytes[start - 1] == b'\n');
        let header = String::from_utf8(bytes[10..start].to_vec()).unwrap();
        let name = entry.name().unwrap().strip_suffix(".npy").unwrap().to_string();
        (name, (header.trim_end().to_string(), bytes[start..].to_vec()))
    };
    (0..count).map(read).collect()
}

#[test]
fn npz_has_the_numbers_of_the_csv_by_every_kind_of_method() {
    let attitudes: Vec<_> = METHODS.map(|(f, s)| npz_has_the_numbers_of(&by(f, s))).into();
    // Control: another method gives another attitude.
    for (n, attitude) in attitudes.iter().enumerate() {
        assert!(!attitudes[..n].contains(attitude), "{:?}", METHODS[n]);
    }
}

/// Checks that npz holds the numbers of the CSV, and returns the bytes of the attitude.
fn npz_has_the_numbers_of(configuration: &str) -> Vec<u8> {
    let (folder, _, rows) = written(configuration);
    let arrays = arrays(&folder, "a.npz");
    let n = rows.len();
    for (name, columns) in [
        ("t", 0..1),
        ("Pi", 1..4),
        ("Gamma", 4..7),
        ("h", 7..8),
        ("f1", 8..9),
        ("f2", 9..10),
        ("K", 10..11),
        ("q", 11..15),
    ] {
        let shape = match columns.len() {
            1 => format!("({n},)"),
            width => format!("({n}, {width})"),
        };
        let (header, bytes) = &arrays[name];
        let expected = format!("{{'descr': '<f8', 'fortran_order': False, 'shape': {shape}, }}");
        assert_eq!(header, &expected);
        let numbers = rows.iter().flat_map(|row| &row[columns.clone()]);
        let expected: Vec<u8> = numbers.flat_map(|x| x.to_le_bytes()).collect();
        assert!(bytes == &expected, "{name}");
    }
    assert_eq!(arrays.len(), 9);

    let (header, bytes) = &arrays["metadata"];
    let characters = bytes.chunks(4).map(|c| u32::from_le_bytes(c.try_into().unwrap()));
    let text: String = characters.map(|c| char::from_u32(c).unwrap()).collect();
    assert!(header.contains(&format!("'descr': '<U{}'", text.chars().count())), "{header}");
    let metadata: serde_json::Value = serde_json::from_str(&text).unwrap();
    assert_eq!(metadata["version"], env!("CARGO_PKG_VERSION"));
    again(&folder, metadata["configuration"].as_str().unwrap());
    arrays["q"].1.clone()
}

#[test]
#[ignore = "long"]
fn parquet_has_the_numbers_of_the_csv_by_every_kind_of_method() {
    for (formulation, scheme) in METHODS {
        parquet_has_the_numbers_of(&by(formulation, scheme));
    }
}

fn parquet_has_the_numbers_of(configuration: &str) {
    let (folder, header, rows) = written(configuration);
    assert!(header.ends_with(&["qw", "qx", "qy", "qz"].map(String::from)));
    let reader = SerializedFileReader::new(File::open(folder.path("a.parquet")).unwrap()).unwrap();
    let about = reader.metadata().file_metadata();
    let names: Vec<&str> = about.schema_descr().columns().iter().map(|c| c.name()).collect();
    assert_eq!(names, header);
    let mut count = 0;
    for (row, expected) in reader.get_row_iter(None).unwrap().zip(&rows) {
        let row = row.unwrap();
        for (i, number) in expected.iter().enumerate() {
            assert_eq!(row.get_double(i).unwrap().to_bits(), number.to_bits());
        }
        count += 1;
    }
    assert_eq!((count, about.num_rows()), (rows.len(), rows.len() as i64));
    let pairs: BTreeMap<&str, &str> = about
        .key_value_metadata()
        .unwrap()
        .iter()
        .map(|pair| (pair.key.as_str(), pair.value.as_deref().unwrap()))
        .collect();
    assert_eq!(pairs["version"], env!("CARGO_PKG_VERSION"));
    again(&folder, pairs["configuration"]);
}

/// Checks that the configuration within a file makes the same file again.
fn again(folder: &Folder, configuration: &str) {
    assert!(configuration.contains("[body]\ninertia = [2.0, 2.0, 1.0]"), "{configuration}");
    folder.write("again.toml", configuration);
    for (out, original) in
        [("again.csv", "a.csv"), ("again.npz", "a.npz"), ("again.parquet", "a.parquet")]
    {
        assert_eq!(folder.heavytop(&["simulate", "again.toml", "--out", out]).code(), 0);
        let read = |name| std::fs::read(folder.path(name)).unwrap();
        assert!(read(out) == read(original), "{out}");
    }
}

#[test]
fn parquet_goes_by_groups_of_rows() {
    // The table has one row more than two groups.
    let end = (2 << 16) as f64 / 8.0;
    let integrator = format!("integrator = {{ scheme = 'rk4', step = 0.125, end = {end} }}");
    let folder = Folder::new();
    folder.write("a.toml", &integrator);
    assert_eq!(folder.heavytop(&["simulate", "a.toml", "--out", "a.parquet"]).code(), 0);
    let reader = SerializedFileReader::new(File::open(folder.path("a.parquet")).unwrap()).unwrap();
    let groups = reader.metadata().row_groups();
    let counts: Vec<i64> = groups.iter().map(|group| group.num_rows()).collect();
    assert_eq!(counts, [1 << 16, 1 << 16, 1]);
}

#[test]
fn parquet_is_compressed_and_knows_the_ranges_of_its_columns() {
    // A header of gzip for each column would weigh in a short table.
    let (folder, header, rows) = written(&CONFIGURATION.replace("end = 4", "end = 40"));
    let file = File::open(folder.path("a.parquet")).unwrap();
    let reader = SerializedFileReader::new(file).unwrap();
    let group = reader.metadata().row_group(0);
    for (i, (column, name)) in group.columns().iter().zip(&header).enumerate() {
        assert!(matches!(column.compression(), Compression::GZIP(_)), "{name}");
        assert!(column.encodings().any(|e| e == Encoding::BYTE_STREAM_SPLIT), "{name}");
        let Some(Statistics::Double(range)) = column.statistics() else { panic!("{name}") };
        let values = rows.iter().map(|row| row[i]);
        let extremes = values.fold([f64::INFINITY, f64::NEG_INFINITY], |[least, most], x| {
            [least.min(x), most.max(x)]
        });
        assert_eq!(range.min_opt().zip(range.max_opt()), Some((&extremes[0], &extremes[1])));
    }
    // Random digits cannot be compressed, but signs, exponents and leading digits can.
    let [stored, plain] = [group.compressed_size(), (8 * header.len() * rows.len()) as i64];
    assert!(stored < plain * 4 / 5, "{stored} {plain}");
}

#[test]
fn what_a_run_that_fails_has_computed_can_be_read_in_every_format() {
    let folder = Folder::new();
    let integrator = "step = 2.0\nend = 100.0\nformulation = 'direct'\nscheme = 'rk4'";
    folder.write("a.toml", &format!("[integrator]\n{integrator}"));
    for out in ["a.csv", "a.npz", "a.parquet"] {
        assert_eq!(folder.heavytop(&["simulate", "a.toml", "--out", out]).code(), 1);
    }
    let partial = ["a.csv.partial", "a.npz.partial", "a.parquet.partial"];
    assert_eq!(folder.names(), [&partial[..], &["a.toml"]].concat());
    let rows = numbers(&folder.read(partial[0])).1;
    let (header, _) = &arrays(&folder, partial[1])["Pi"];
    assert!(header.contains(&format!("({}, 3)", rows.len())), "{header}");
    let reader = SerializedFileReader::new(File::open(folder.path(partial[2])).unwrap()).unwrap();
    assert_eq!(reader.metadata().file_metadata().num_rows(), rows.len() as i64);
}

#[test]
fn the_summary_in_json_is_that_of_the_rows() {
    let (folder, header, rows) = written(CONFIGURATION);
    let run = folder.heavytop(&["simulate", "a.toml", "--out", "a.npz", "--json"]);
    let summary: serde_json::Value = serde_json::from_str(&run.stdout()).unwrap();
    assert_eq!((run.code(), run.complaints()), (0, String::new()));
    assert_eq!(summary["steps"], 200);
    assert_eq!(summary["scheme"], "gauss-4");
    let last = rows.last().unwrap();
    for i in 0..3 {
        assert_eq!(summary["angular_momentum"][i], last[1 + i]);
        assert_eq!(summary["vertical"][i], last[4 + i]);
    }
    for (i, symbol) in header.iter().enumerate().take(11).skip(7) {
        let most = rows.iter().map(|row| (row[i] - rows[0][i]).abs()).fold(0.0, f64::max);
        assert_eq!(summary["deviations"][symbol], most, "{symbol}");
    }
}
