//! What edges and corners are called: `V2V3` of the first contour, `V2′V3′` of the second.

use super::Point;

/// The contour of an edge, and the corner there at which it starts.
pub(super) fn place(contours: &[Vec<Point>], edge: u32) -> [usize; 2] {
    let mut corner = edge as usize;
    for (contour, corners) in contours.iter().enumerate() {
        if corner < corners.len() {
            return [contour, corner];
        }
        corner -= corners.len();
    }
    [contours.len(), 0]
}

/// Both ends of an edge, as it was given.
pub(super) fn ends(contours: &[Vec<Point>], edge: u32) -> [Point; 2] {
    let [contour, corner] = place(contours, edge);
    let Some(corners) = contours.get(contour) else { return [[0.0; 2]; 2] };
    [corners[corner], corners[(corner + 1) % corners.len()]]
}

/// The name of a corner.
pub(super) fn corner(contour: usize, corner: usize) -> String {
    format!("V{corner}{}", "′".repeat(contour.min(3)))
}

/// The name of an edge.
pub(super) fn edge(contours: &[Vec<Point>], edge: u32) -> String {
    let [contour, start] = place(contours, edge);
    let end = contours.get(contour).map_or(0, |corners| (start + 1) % corners.len());
    corner(contour, start) + &corner(contour, end)
}
