//! The container of 3MF: a ZIP archive of three parts (APPNOTE.TXT, sections 4.3 and 4.4), as small as readers need it and without a date.

use flate2::read::DeflateDecoder;
use flate2::write::DeflateEncoder;
use flate2::{Compression, Crc};
use std::io::{Read as _, Write as _};

/// Names and texts of the parts beside the model.
const TYPES: [&str; 2] = [
    "[Content_Types].xml",
    "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n<Types xmlns=\"http://schemas.openxmlformats.org/package/2006/content-types\">\n\
<Default Extension=\"rels\" ContentType=\"application/vnd.openxmlformats-package.relationships+xml\"/>\n\
<Default Extension=\"model\" ContentType=\"application/vnd.ms-package.3dmanufacturing-3dmodel+xml\"/>\n</Types>\n",
];
const RELATIONS: [&str; 2] = [
    "_rels/.rels",
    "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n<Relationships xmlns=\"http://schemas.openxmlformats.org/package/2006/relationships\">\n\
<Relationship Target=\"/3D/3dmodel.model\" Id=\"rel0\" Type=\"http://schemas.microsoft.com/3dmanufacturing/2013/01/3dmodel\"/>\n</Relationships>\n",
];
const MODEL: &str = "3D/3dmodel.model";

/// Signatures of a part, of its entry in the list at the end, and of the end.
const PART: u32 = 0x0403_4b50;
const ENTRY: u32 = 0x0201_4b50;
const END: u32 = 0x0605_4b50;
/// Bytes of a part before its name.
const PART_HEAD: usize = 30;
/// Version 2.0 of the format, and deflate, the way of packing.
const VERSION: u16 = 20;
const DEFLATE: u16 = 8;
/// 1980-01-01, the first day that a ZIP archive knows: no clock, the same bytes every time.
const DATE: u16 = 0x0021;
/// What stands both before a part and in the list at the end.
struct Head {
    common: Vec<u8>,
    packed: Vec<u8>,
}

impl Head {
    fn of([name, text]: [&str; 2]) -> Option<Self> {
        let mut encoder = DeflateEncoder::new(Vec::new(), Compression::default());
        // Writing to a list cannot fail.
        encoder.write_all(text.as_bytes()).ok()?;
        let packed = encoder.finish().ok()?;
        let length = |bytes: usize| u32::try_from(bytes).ok();
        let mut common = Vec::with_capacity(PART_HEAD);
        [VERSION, 0, DEFLATE, 0, DATE].iter().for_each(|number| common.extend(number.to_le_bytes()));
        let numbers = [check_sum(text.as_bytes()), length(packed.len())?, length(text.len())?];
        numbers.iter().for_each(|number| common.extend(number.to_le_bytes()));
        [u16::try_from(name.len()).ok()?, 0].iter().for_each(|number| common.extend(number.to_le_bytes()));
        Some(Self { common, packed })
    }
}

fn check_sum(bytes: &[u8]) -> u32 {
    let mut sum = Crc::new();
    sum.update(bytes);
    sum.sum()
}

/// The list at the end, of the parts with what stands before them, where they begin, and their names.
fn list<'a>(parts: impl IntoIterator<Item = (&'a [u8], usize, &'a str)>, length: usize) -> Option<Vec<u8>> {
    let (mut out, mut count) = (Vec::new(), 0_u16);
    for (common, offset, name) in parts {
        out.extend(ENTRY.to_le_bytes());
        out.extend(VERSION.to_le_bytes());
        out.extend(common);
        // No remark, the first disk, no attributes.
        out.extend([0; 10]);
        out.extend(u32::try_from(offset).ok()?.to_le_bytes());
        out.extend(name.as_bytes());
        count += 1;
    }
    let own = out.len() as u32;
    out.extend(END.to_le_bytes());
    out.extend([0; 4]);
    [count; 2].iter().for_each(|number| out.extend(number.to_le_bytes()));
    [own, u32::try_from(length).ok()?].iter().for_each(|number| out.extend(number.to_le_bytes()));
    out.extend([0; 2]);
    Some(out)
}

/// The file with this model; `None` if it would be larger than 4 GiB, which such archives do not hold.
pub(super) fn pack(model: &str) -> Option<Vec<u8>> {
    let mut out = Vec::new();
    let (mut heads, parts) = (Vec::new(), [TYPES, RELATIONS, [MODEL, model]]);
    for [name, text] in parts {
        let Head { common, packed } = Head::of([name, text])?;
        let offset = out.len();
        out.extend(PART.to_le_bytes());
        out.extend(&common);
        out.extend(name.as_bytes());
        out.extend(&packed);
        heads.push((common, offset, name));
    }
    let entries = heads.iter().map(|(common, offset, name)| (common.as_slice(), *offset, *name));
    let mut end = list(entries, out.len())?;
    out.append(&mut end);
    Some(out)
}

/// The model of a file of ours.
///
/// # Errors
/// A message.
pub(super) fn unpack(bytes: &[u8]) -> Result<String, String> {
    let mut at = 0;
    let mut entries = Vec::new();
    let mut texts = Vec::new();
    for name in [TYPES[0], RELATIONS[0], MODEL] {
        let wrong = |what: &str| format!("{name}: {what}");
        let offset = at;
        let mut next = |count: usize| {
            let own = bytes.get(at..).and_then(|rest| rest.get(..count))?;
            at += count;
            Some(own)
        };
        let short = || wrong("the archive is truncated");
        let head = next(PART_HEAD).ok_or_else(short)?;
        let (signature, common) = head.split_at(4);
        let number =
            |from: usize| common.get(from..).and_then(<[u8]>::first_chunk).map_or(0, |own| u32::from_le_bytes(*own));
        let [sum, packed, length] = [10, 14, 18].map(number);
        if signature != PART.to_le_bytes() || next(name.len()) != Some(name.as_bytes()) {
            return Err(wrong("the part is missing"));
        }
        let packed = next(packed as usize).ok_or_else(short)?;
        let mut text = Vec::new();
        let unpacked = DeflateDecoder::new(packed).take(u64::from(length) + 1).read_to_end(&mut text);
        if unpacked.is_err() || text.len() != length as usize || check_sum(&text) != sum {
            return Err(wrong("its checksum does not match"));
        }
        entries.push((common, offset, name));
        texts.push(String::from_utf8(text).map_err(|_| wrong("not text"))?);
    }
    match texts.as_slice() {
        [types, relations, _]
            if types == TYPES[1] && relations == RELATIONS[1] && Some(&bytes[at..]) == list(entries, at).as_deref() =>
        {
            Ok(texts.pop().unwrap_or_default())
        }
        _ => Err("its types, relations or list of parts do not match its parts".to_owned()),
    }
}
