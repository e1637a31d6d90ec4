//! Files of arrays: those that `export` writes, and those by which a run starts.

use super::systems_of_arrays::{array, cases, configuration, succeeded};
use crate::program::{Folder, numbers};
use base64::Engine;
use base64::engine::general_purpose::STANDARD;
use std::io::Write;

/// Exported files hold the spins of the run, with the first index along x. A run that starts from them has the same bits.
#[test]
fn a_run_goes_on_from_its_files() {
    let folder = Folder::new();
    let case = &cases()[0];
    folder.write("a.toml", &configuration(case));
    succeeded(&folder.heavytop(&["simulate", "a.toml", "--out", "a.npz"]));
    let spins = array(&std::fs::read(folder.path("a.npz")).unwrap(), "S").1;
    let last = &spins[spins.len() - 18..];
    for (format, names) in [
        ("ovf", &["S_000000.ovf", "S_000002.ovf", "S_000003.ovf"][..]),
        ("vti", &["S.pvd", "S_000000.vti", "S_000002.vti", "S_000003.vti"]),
    ] {
        let arguments = ["export", "a.npz", "--out", format, "--format", format, "--every", "2"];
        // The files of the command are replaced.
        for _ in 0..2 {
            succeeded(&folder.heavytop(&arguments));
        }
        let mut found: Vec<_> = std::fs::read_dir(folder.path(format))
            .unwrap()
            .map(|entry| entry.unwrap().file_name().into_string().unwrap())
            .collect();
        found.sort();
        assert_eq!(found, names);
    }
    // 2 cells along x and 3 along y: x is the fastest.
    let order = [0, 3, 1, 4, 2, 5].map(|cell| &last[3 * cell..3 * cell + 3]).concat();
    let bytes: Vec<u8> = order.iter().flat_map(|x| x.to_le_bytes()).collect();
    for name in ["ovf/S_000003.ovf", "vti/S_000003.vti"] {
        let file = std::fs::read(folder.path(name)).unwrap();
        assert!(file.windows(bytes.len()).any(|window| window == bytes), "{name}");
    }
    let collection = folder.read("vti/S.pvd");
    assert!(
        collection.contains("timestep=\"1.0\" part=\"0\" file=\"S_000003.vti\""),
        "{collection}"
    );
    let text = String::from_utf8_lossy(&std::fs::read(folder.path("ovf/S_000003.ovf")).unwrap())
        .into_owned();
    for part in
        ["# xnodes: 2\n# ynodes: 3\n# znodes: 1\n", "# valuedim: 3\n", "simulation time: 1 s"]
    {
        assert!(text.contains(part), "{text}");
    }
    let by_hand = {
        let numbers: Vec<String> =
            last.chunks(3).map(|s| format!("[{:?}, {:?}, {:?}]", s[0], s[1], s[2])).collect();
        format!("initial = {{ S = [{}] }}", numbers.join(", "))
    };
    let (head, tail) = text.split_once("# Begin: Data Binary 8").unwrap();
    let _ = tail;
    let rows: Vec<String> =
        order.chunks(3).map(|s| format!("{:?} {:?} {:?}", s[0], s[1], s[2])).collect();
    folder.write(
        "text.ovf",
        &format!("{head}# Begin: Data Text\n{}\n# End: Data Text\n", rows.join("\n")),
    );
    let short: Vec<u8> = [1_234_567.0_f32]
        .into_iter()
        .chain(order.iter().map(|x| *x as f32))
        .flat_map(f32::to_le_bytes)
        .collect();
    let mut single = format!("{head}# Begin: Data Binary 4\n").into_bytes();
    single.extend(short);
    std::fs::write(folder.path("single.omf"), single).unwrap();
    let run = |start: &str| {
        let text = configuration(case).replace(&format!("initial = {{ {} }}", case.start.0), start);
        folder.write("b.toml", &text);
        succeeded(&folder.heavytop(&["simulate", "b.toml", "--out", "b.csv", "--force"]));
        numbers(&folder.read("b.csv")).1
    };
    let expected = run(&by_hand);
    assert_eq!(expected[0][1..19], *last);
    let mut images = images(&order);
    for (name, file) in &images {
        std::fs::write(folder.path(name), file).unwrap();
    }
    let mut array = numpy(&[2, 3, 3], last);
    std::fs::write(folder.path("a.npy"), &array).unwrap();
    let files = ["a.npz", "a.npy", "ovf/S_000003.ovf", "text.ovf", "vti/S_000003.vti"];
    for file in files.into_iter().chain(images.iter().map(|(name, _)| name.as_str())) {
        assert_eq!(run(&format!("initial_file = '{file}'")), expected, "{file}");
    }
    let single = run("initial_file = 'single.omf'");
    assert!(
        single[0][1..19].iter().zip(last).all(|(a, b)| (a - b).abs() < 1e-7) && single != expected
    );
    // A bit that has changed on the disk is noticed by the sum of the archive.
    let mut archive = std::fs::read(folder.path("a.npz")).unwrap();
    let place = archive.windows(8).position(|eight| eight == last[3].to_le_bytes()).unwrap();
    archive[place] ^= 1;
    std::fs::write(folder.path("cut_bit.npz"), archive).unwrap();
    // What is cut short or has another shape is refused by name.
    array.pop();
    std::fs::write(folder.path("cut.npy"), &array).unwrap();
    for (name, file) in &mut images {
        let text = String::from_utf8_lossy(file).into_owned();
        *file = match name.as_str() {
            "ascii.vti" => text.replace("0 2 0 3 0 1", "0 3 0 2 0 1").into(),
            "zlib.vti" => text.replace("vtkZLib", "vtkLZ4").into(),
            _ => text.replace("AAAA", "").into(),
        };
        std::fs::write(folder.path(&format!("cut_{name}")), file).unwrap();
    }
    for (file, said) in [
        ("cut_bit.npz", "hecksum"),
        ("cut.npy", "it has not as many numbers as its header says"),
        ("cut_ascii.vti", "the shape of S is [3, 2, 1, 3], not [2, 3, 3]"),
        ("cut_zlib.vti", "compressed by vtkLZ4DataCompressor"),
        ("cut_base64.vti", "no Base64"),
        ("cut_single.vti", "no Base64"),
    ] {
        let start = format!("initial_file = '{file}'");
        let text =
            configuration(case).replace(&format!("initial = {{ {} }}", case.start.0), &start);
        folder.write("b.toml", &text);
        let done = folder.heavytop(&["simulate", "b.toml", "--out", "c.csv"]);
        assert!(done.code() == 2 && done.stderr().contains(said), "{file}: {}", done.stderr());
    }
}

/// Image data of VTK with vectors on 2 × 3 cells or points, in the ways of ParaView, and the same numbers.
fn images(order: &[f64]) -> Vec<(String, Vec<u8>)> {
    let image = |attributes: &str, cells: &str, data: [&str; 2], array: &str, after: &str| {
        let [data, kind] = data;
        format!(
            "<?xml version=\"1.0\"?>\n<VTKFile type=\"ImageData\" {attributes}>\n<ImageData>\n\
             <Piece Extent=\"{cells}\">\n<{data}>\n<DataArray type=\"Float64\" Name=\"other\" format=\"ascii\">1 2</DataArray>\n\
             <DataArray type=\"{kind}\" Name=\"S\" NumberOfComponents=\"3\" {array}</DataArray>\n</{data}>\n\
             </Piece>\n</ImageData>\n{after}</VTKFile>\n"
        )
    };
    let bytes: Vec<u8> = order.iter().flat_map(|x| x.to_le_bytes()).collect();
    let cells = "0 2 0 3 0 1";
    let words: Vec<String> = order.iter().map(|x| format!("{x:?}")).collect();
    let ascii = format!("format=\"ascii\">{}", words.join(" "));
    let long = "byte_order=\"LittleEndian\" header_type=\"UInt64\"";
    let mut counted = (bytes.len() as u64).to_le_bytes().to_vec();
    let alone = STANDARD.encode(&counted) + &STANDARD.encode(&bytes);
    counted.extend(&bytes);
    let appended = |text: &str| {
        format!(
            "<AppendedData encoding=\"base64\">\n _{}{text}\n</AppendedData>\n",
            STANDARD.encode(b"123456")
        )
    };
    // Two blocks, the second of which is shorter.
    let (first, second) = bytes.split_at(100);
    let packed = [first, second].map(|block| {
        let mut packer =
            flate2::write::ZlibEncoder::new(Vec::new(), flate2::Compression::default());
        packer.write_all(block).unwrap();
        packer.finish().unwrap()
    });
    let counts = [2, 100, second.len(), packed[0].len(), packed[1].len()];
    let counts: Vec<u8> = counts.iter().flat_map(|n| (*n as u32).to_le_bytes()).collect();
    let zlib = STANDARD.encode(counts) + &STANDARD.encode(packed.concat());
    let short =
        "byte_order=\"LittleEndian\" header_type=\"UInt32\" compressor=\"vtkZLibDataCompressor\"";
    // The highest byte of each number is the first one.
    let mut big = (bytes.len() as u32).to_be_bytes().to_vec();
    big.extend(order.iter().flat_map(|x| x.to_be_bytes()));
    let (on_cells, on_points) = (["CellData", "Float64"], ["PointData", "Float64"]);
    let inline = |text: &str| format!("format=\"binary\">{text}");
    let all = [
        ("ascii.vti", image("", cells, on_cells, &ascii, "")),
        ("base64.vti", image(long, "0 1 0 2 0 0", on_points, &inline(&alone), "")),
        (
            "single.vti",
            image(
                long,
                cells,
                on_cells,
                "format=\"appended\" offset=\"8\">",
                &appended(&STANDARD.encode(counted)),
            ),
        ),
        (
            "zlib.vti",
            image(short, cells, on_cells, "format=\"appended\" offset=\"8\">", &appended(&zlib)),
        ),
        (
            "big.vti",
            image("byte_order=\"BigEndian\"", cells, on_cells, &inline(&STANDARD.encode(big)), ""),
        ),
    ];
    all.map(|(name, text)| (name.to_owned(), text.into_bytes())).into()
}

/// A file of `numpy.save`.
fn numpy(shape: &[usize], numbers: &[f64]) -> Vec<u8> {
    let counts: Vec<String> = shape.iter().map(ToString::to_string).collect();
    let header =
        format!("{{'descr': '<f8', 'fortran_order': False, 'shape': ({}), }}\n", counts.join(", "));
    let mut file = b"\x93NUMPY\x01\x00".to_vec();
    file.extend((header.len() as u16).to_le_bytes());
    file.extend(header.bytes());
    file.extend(numbers.iter().flat_map(|x| x.to_le_bytes()));
    file
}
