//! Where the lectures that define the scope treat what a lab shows: their titles and headings.
//!
//! Facts for a reference, in the languages of the sources; the lectures themselves are not here.

use super::LabInfo;

/// A place in a lecture.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Topic {
    /// The lecture's title.
    pub lecture: &'static str,
    /// The heading there.
    pub heading: &'static str,
}

/// The lectures, in the order in which the sources number them.
const TUZLA: &str = "Odsijecanje i scan konverzija";
const ITALIAN: &str = "Grafica al calcolatore, 6: Pipeline di rasterizzazione";
const RUSSIAN: &str = "Software renderer, 2: растеризация и интерполяция атрибутов";
const SLOVENE: &str = "Grafični cevovod";
const ESTONIAN: &str = "Nähtamatute pindade eemaldamine";

const fn at(lecture: &'static str, heading: &'static str) -> Topic {
    Topic { lecture, heading }
}

/// Each lab that a lecture treats, by name.
const TOPICS: &[(&str, &[Topic])] = &[
    (
        "pipeline",
        &[
            at(ITALIAN, "Pipeline di rasterizzazione"),
            at(SLOVENE, "Grafični cevovod"),
            at(TUZLA, "Rendering trougla"),
        ],
    ),
    (
        "transform",
        &[at(TUZLA, "Transformacija"), at(ITALIAN, "Pipeline geometrica"), at(SLOVENE, "Koordinate zaslona")],
    ),
    ("point-clipping", &[at(ITALIAN, "Clipping di un punto")]),
    (
        "cohen-sutherland",
        &[
            at(ITALIAN, "Clipping di un segmento (Cohen-Sutherland)"),
            at(ESTONIAN, "Cohen-Sutherlandi algoritm"),
        ],
    ),
    ("liang-barsky", &[at(ITALIAN, "Clipping di un segmento (Liang-Barsky)")]),
    (
        "sutherland-hodgman",
        &[
            at(ITALIAN, "Clipping di un poligono (Sutherland-Hodgman)"),
            at(ESTONIAN, "Sutherland-Hodgmani algoritm"),
        ],
    ),
    ("weiler-atherton", &[at(ITALIAN, "Clipping di un poligono")]),
    (
        "clip-plane",
        &[
            at(TUZLA, "Odsijecanje: Testiranje unutar/izvan"),
            at(TUZLA, "Odsijecanje: Presijecanje stranica/ravan"),
        ],
    ),
    ("clip-triangle", &[at(TUZLA, "Odsijecanje: Presijecanje stranica/ravan"), at(SLOVENE, "Rezanje")]),
    (
        "back-face",
        &[
            at(TUZLA, "Backface Culling"),
            at(ITALIAN, "Back-face culling"),
            at(SLOVENE, "Izločanje ploskev (face culling)"),
            at(ESTONIAN, "Tagakülgede tuvastamine"),
        ],
    ),
    ("frustum-culling", &[at(TUZLA, "Culling"), at(SLOVENE, "Izločanje predmetov izven prostora pogleda")]),
    ("bvh", &[at(SLOVENE, "Izločanje predmetov izven prostora pogleda")]),
    ("scanline", &[at(TUZLA, "Rasterizacija trougla"), at(RUSSIAN, "«Стандартный» алгоритм")]),
    ("aabb", &[at(RUSSIAN, "AABB-алгоритм"), at(SLOVENE, "Rasterizacija")]),
    ("backtracking", &[at(RUSSIAN, "Backtracking-алгоритм")]),
    ("zigzag", &[at(RUSSIAN, "Zigzag-алгоритм")]),
    ("homogeneous", &[at(RUSSIAN, "Алгоритм растеризации в однородных координатах")]),
    ("tiled", &[at(SLOVENE, "Rasterizacija")]),
    ("msaa", &[at(SLOVENE, "Mehčanje robov")]),
    ("area-ratios", &[at(RUSSIAN, "Интерполяция атрибутов")]),
    ("plane-equation", &[at(TUZLA, "Z interpolacija"), at(ESTONIAN, "Sügavuspuhver")]),
    (
        "perspective-correction",
        &[at(RUSSIAN, "Интерполяция атрибутов"), at(TUZLA, "Interpolacija svojstava")],
    ),
    ("lighting", &[at(SLOVENE, "Senčilnik fragmentov")]),
    ("shading", &[at(SLOVENE, "Senčilnik oglišč"), at(SLOVENE, "Senčilnik fragmentov")]),
    ("stress", &[at(RUSSIAN, "Точность"), at(TUZLA, "Sekvencijalna rasterizacija")]),
    ("edge-table", &[at(ESTONIAN, "Ridahaaval töötlemine")]),
    ("stencil", &[at(SLOVENE, "Test šablone")]),
    (
        "z-buffer",
        &[
            at(TUZLA, "Z-buffer"),
            at(ITALIAN, "HSR: L'algoritmo z-buffer"),
            at(ESTONIAN, "Sügavuspuhver"),
            at(SLOVENE, "Test globine"),
        ],
    ),
    ("depth-precision", &[at(TUZLA, "Z-buffer"), at(SLOVENE, "Test globine")]),
    ("blend", &[at(SLOVENE, "Mešanje")]),
];

impl LabInfo {
    /// Where the lectures treat what the lab shows; empty if they do not.
    pub fn topics(&self) -> &'static [Topic] {
        TOPICS.iter().find(|(name, _)| *name == self.name).map_or(&[], |(_, topics)| *topics)
    }
}
