//! Work–precision plots: error against unknowns, seconds and memory, log–log.

use plotters::coord::combinators::IntoLogRange;
use plotters::prelude::*;
use std::path::Path;

/// One curve over one kind of work.
#[derive(Clone, Debug, PartialEq)]
pub struct Line {
    /// Name in the legend.
    pub name: String,
    /// Points (work, error) from coarse to fine.
    pub points: Vec<(f64, f64)>,
}

/// One panel: curves over one kind of work.
#[derive(Clone, Debug, PartialEq)]
pub struct Panel {
    /// The kind of work, with its unit.
    pub work: &'static str,
    /// The curves, in the same order in every panel.
    pub lines: Vec<Line>,
}

/// What stands on a plot.
pub struct Plot<'a> {
    /// First line.
    pub title: &'a str,
    /// What was measured, in smaller letters.
    pub about: &'a str,
    /// Last line: machine and commit.
    pub origin: &'a str,
    /// Name of the error.
    pub error: &'a str,
    /// Error of the model itself, drawn as a line where it is not 0.
    pub floor: f64,
    /// Side by side.
    pub panels: Vec<Panel>,
}

const COLOURS: [RGBColor; 8] = [
    RGBColor(31, 119, 180),
    RGBColor(214, 39, 40),
    RGBColor(44, 160, 44),
    RGBColor(148, 103, 189),
    RGBColor(255, 127, 14),
    RGBColor(90, 90, 90),
    RGBColor(23, 170, 190),
    RGBColor(140, 86, 75),
];
const GREY: RGBColor = RGBColor(150, 150, 150);
/// Width of a panel and of a column of the legend, heights of a panel, of the title, of a line of the legend and of the
/// last line, in pixels.
const PANEL: u32 = 380;
const HEIGHTS: [u32; 4] = [340, 50, 16, 24];
/// A model's error this far below all others is told in the legend alone.
const FAR_BELOW: f64 = 1.0 / 30.0;

type Area<'b> = DrawingArea<SVGBackend<'b>, plotters::coord::Shift>;
type Drawn<'b> = Result<(), DrawingAreaErrorKind<<SVGBackend<'b> as DrawingBackend>::ErrorType>>;

impl Plot<'_> {
    /// Writes the plot as SVG: title, panels, legend, and where it was measured.
    pub fn write(&self, path: &Path) -> Result<(), String> {
        let [panel, title, line, foot] = HEIGHTS;
        let columns = self.panels.len() as u32;
        let entries = self.panels.first().map_or(0, |panel| panel.lines.len()) as u32 + (self.floor > 0.0) as u32;
        let legend = 6 + line * entries.div_ceil(columns.max(1));
        let root = SVGBackend::new(path, (PANEL * columns.max(1), title + panel + legend + foot)).into_drawing_area();
        let failed = |error: &dyn std::fmt::Display| format!("{}: {error}", path.display());
        root.fill(&WHITE).map_err(|e| failed(&e))?;
        let (head, rest) = root.split_vertically(title);
        let (body, rest) = rest.split_vertically(panel);
        let (names, last) = rest.split_vertically(legend);
        let text = |size: u32| ("sans-serif", size).into_font();
        head.draw(&Text::new(self.title, (12, 8), text(17))).map_err(|e| failed(&e))?;
        head.draw(&Text::new(self.about, (12, 31), text(12))).map_err(|e| failed(&e))?;
        last.draw(&Text::new(self.origin, (12, 6), text(11))).map_err(|e| failed(&e))?;
        for (area, panel) in body.split_evenly((1, self.panels.len())).iter().zip(&self.panels) {
            self.panel(area, panel).map_err(|e| failed(&e))?;
        }
        self.legend(&names, columns).map_err(|e| failed(&e))?;
        root.present().map_err(|e| failed(&e))
    }

    fn panel<'b>(&self, area: &Area<'b>, panel: &Panel) -> Drawn<'b> {
        let all = || panel.lines.iter().flat_map(|line| &line.points).filter(|point| is_drawn(point));
        let works = range(all().map(|p| p.0));
        let lowest = all().map(|p| p.1).fold(f64::INFINITY, f64::min);
        let floor = Some(self.floor).filter(|&floor| floor > 0.0 && floor > FAR_BELOW * lowest);
        let errors = range(all().map(|p| p.1).chain(floor));
        let mut chart = ChartBuilder::on(area)
            .margin(8)
            .margin_right(14)
            .x_label_area_size(38)
            .y_label_area_size(58)
            .build_cartesian_2d((works.0..works.1).log_scale(), (errors.0..errors.1).log_scale())?;
        chart
            .configure_mesh()
            .light_line_style(RGBColor(240, 240, 240))
            // Fewer than ten a decade: powers of ten alone are lines with labels.
            .x_labels(8)
            .y_labels(8)
            .x_desc(panel.work)
            .y_desc(self.error)
            .x_label_formatter(&decade)
            .y_label_formatter(&decade)
            .draw()?;
        if let Some(floor) = floor {
            let line = [(works.0, floor), (works.1, floor)];
            chart.draw_series(DashedLineSeries::new(line, 6, 4, GREY.stroke_width(2)))?;
        }
        for (index, line) in panel.lines.iter().enumerate() {
            let points: Vec<(f64, f64)> = line.points.iter().copied().filter(is_drawn).collect();
            chart.draw_series(LineSeries::new(points.iter().copied(), colour(index).stroke_width(2)))?;
            let plane = chart.plotting_area();
            points.iter().try_for_each(|&point| plane.draw(&(EmptyElement::at(point) + marker(index))))?;
        }
        Ok(())
    }

    /// Below the panels, in as many columns as there are panels.
    fn legend<'b>(&self, area: &Area<'b>, columns: u32) -> Drawn<'b> {
        let lines = self.panels.first().map_or(&[][..], |panel| &panel.lines);
        let count = lines.len() + (self.floor > 0.0) as usize;
        let rows = count.div_ceil(columns.max(1) as usize).max(1);
        let place = |index: usize| ((12 + PANEL as usize * (index / rows)) as i32, (10 + 16 * (index % rows)) as i32);
        let name = |text: String, (x, y)| Text::new(text, (x + 32, y - 6), ("sans-serif", 12));
        for (index, line) in lines.iter().enumerate() {
            let (x, y) = place(index);
            area.draw(&PathElement::new([(x, y), (x + 24, y)], colour(index).stroke_width(2)))?;
            area.draw(&(EmptyElement::at((x + 12, y)) + marker(index)))?;
            area.draw(&name(line.name.clone(), (x, y)))?;
        }
        if self.floor > 0.0 {
            let (x, y) = place(lines.len());
            for dash in [0, 10, 20] {
                area.draw(&PathElement::new([(x + dash, y), (x + dash + 6, y)], GREY.stroke_width(2)))?;
            }
            area.draw(&name(format!("the model's own error, {:.1e}", self.floor), (x, y)))?;
        }
        Ok(())
    }
}

fn colour(index: usize) -> RGBColor {
    COLOURS[index % COLOURS.len()]
}

/// A shape about a point in the curve's colour: circles, squares, triangles and rhombs in turn, the first four larger,
/// so that they show beneath later ones.
fn marker(index: usize) -> Polygon<(i32, i32)> {
    let corners = [16, 4, 3, 4][index % 4];
    let (turn, size) = ([0.0, 0.125, 0.25, 0.0][index % 4], if index < 4 { 5.0 } else { 4.0 });
    let corner = |i: usize| {
        let (sin, cos) = (std::f64::consts::TAU * (i as f64 / corners as f64 - turn)).sin_cos();
        ((size * cos).round() as i32, (size * sin).round() as i32)
    };
    Polygon::new((0..corners).map(corner).collect::<Vec<_>>(), colour(index).filled())
}

fn is_drawn((work, error): &(f64, f64)) -> bool {
    [work, error].iter().all(|value| value.is_finite() && **value > 0.0)
}

/// The label of a power of ten, nothing for what lies between.
fn decade(value: &f64) -> String {
    let power = value.log10().round();
    if (value.log10() - power).abs() > 1e-6 {
        return String::new();
    }
    if (-1.0..4.0).contains(&power) { format!("{}", 10f64.powf(power)) } else { format!("1e{power:.0}") }
}

/// From a little below the positive values to a little above, as far as the next powers of ten where fewer than two
/// would lie between.
fn range(values: impl Iterator<Item = f64>) -> (f64, f64) {
    let (low, high) = values
        .filter(|value| *value > 0.0 && value.is_finite())
        .fold((f64::INFINITY, 0.0f64), |(low, high), value| (low.min(value), high.max(value)));
    if low > high {
        return (0.1, 10.0);
    }
    let (mut low, mut high) = (low.log10() - 0.12, high.log10() + 0.12);
    while high.floor() - low.ceil() < 1.0 {
        // The nearer one of the next powers.
        let (below, above) = (low - (low - 1e-9).floor(), (high + 1e-9).ceil() - high);
        if below < above { low -= below } else { high += above }
    }
    (10f64.powf(low - 1e-9), 10f64.powf(high + 1e-9))
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Every range holds its values and at least two powers of ten, and wastes less than a decade a side.
    #[test]
    fn ranges_hold_two_decades() {
        for values in [[1.0, 1.0], [9.0, 70.0], [0.2, 0.5], [3e-6, 0.4], [10.0, 100.0]] {
            let (low, high) = range(values.into_iter());
            let powers = (-12..12).filter(|&power| (low..=high).contains(&10f64.powi(power))).count();
            assert!(low < values[0] && values[1] < high && powers >= 2, "{values:?} {low} {high}");
            assert!(values[0] / low < 14.0 && high / values[1] < 14.0, "{values:?} {low} {high}");
        }
        assert_eq!(range(std::iter::empty()), (0.1, 10.0));
        assert_eq!([0.01, 0.1, 20.0, 1e3, 1e5].map(|value| decade(&value)), ["1e-2", "0.1", "", "1000", "1e5"]);
    }
}
