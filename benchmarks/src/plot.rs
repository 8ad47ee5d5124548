//! Work–precision plots: error against unknowns, seconds and memory, log–log.

use plotters::coord::combinators::IntoLogRange;
use plotters::prelude::*;
use std::path::Path;

/// One curve: its name, and its points (work, error).
#[derive(Clone, Debug, PartialEq)]
pub struct Line {
    /// Name in the legend.
    pub name: String,
    /// (work, error) from coarse to fine.
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
    /// Last line: machine and commit.
    pub origin: &'a str,
    /// Name of the error.
    pub error: &'a str,
    /// Error of the model itself, drawn as a line where it is not 0.
    pub floor: f64,
    /// Side by side.
    pub panels: Vec<Panel>,
}

const COLOURS: [RGBColor; 6] = [
    RGBColor(31, 119, 180),
    RGBColor(214, 39, 40),
    RGBColor(44, 160, 44),
    RGBColor(148, 103, 189),
    RGBColor(255, 127, 14),
    RGBColor(90, 90, 90),
];

impl Plot<'_> {
    /// Writes the plot as SVG.
    pub fn write(&self, path: &Path) -> Result<(), String> {
        let size = (380 * self.panels.len() as u32, 430);
        let failed = |error: &dyn std::fmt::Display| format!("{}: {error}", path.display());
        let root = SVGBackend::new(path, size).into_drawing_area();
        root.fill(&WHITE).map_err(|e| failed(&e))?;
        let (head, rest) = root.split_vertically(34);
        let (body, foot) = rest.split_vertically(372);
        let text = |size: u32| ("sans-serif", size).into_font();
        head.draw(&Text::new(self.title, (12, 10), text(17))).map_err(|e| failed(&e))?;
        foot.draw(&Text::new(self.origin, (12, 4), text(11))).map_err(|e| failed(&e))?;
        for (area, panel) in body.split_evenly((1, self.panels.len())).iter().zip(&self.panels) {
            self.panel(area, panel).map_err(|e| failed(&e))?;
        }
        root.present().map_err(|e| failed(&e))
    }

    fn panel<'b>(
        &self,
        area: &DrawingArea<SVGBackend<'b>, plotters::coord::Shift>,
        panel: &Panel,
    ) -> Result<(), DrawingAreaErrorKind<<SVGBackend<'b> as DrawingBackend>::ErrorType>> {
        let all = || panel.lines.iter().flat_map(|line| &line.points);
        let works = range(all().map(|p| p.0));
        let errors = range(all().map(|p| p.1).chain((self.floor > 0.0).then_some(self.floor)));
        let mut chart = ChartBuilder::on(area)
            .margin(8)
            .x_label_area_size(38)
            .y_label_area_size(58)
            .build_cartesian_2d((works.0..works.1).log_scale(), (errors.0..errors.1).log_scale())?;
        let number = |value: &f64| format!("1e{:.0}", value.log10());
        let decade = |value: &f64| {
            if (value.log10() - value.log10().round()).abs() < 1e-6 { number(value) } else { String::new() }
        };
        chart
            .configure_mesh()
            .light_line_style(RGBColor(240, 240, 240))
            .x_desc(panel.work)
            .y_desc(self.error)
            .x_label_formatter(&decade)
            .y_label_formatter(&decade)
            .draw()?;
        if self.floor > 0.0 {
            let line = [(works.0, self.floor), (works.1, self.floor)];
            let grey = RGBColor(150, 150, 150);
            chart
                .draw_series(LineSeries::new(line, grey))?
                .label("the model's own error")
                .legend(move |(x, y)| PathElement::new([(x, y), (x + 16, y)], grey));
        }
        for (line, colour) in panel.lines.iter().zip(COLOURS.iter().cycle()) {
            let style = colour.stroke_width(2);
            chart
                .draw_series(LineSeries::new(line.points.iter().copied(), style))?
                .label(&line.name)
                .legend(move |(x, y)| PathElement::new([(x, y), (x + 16, y)], style));
            chart.draw_series(line.points.iter().map(|&point| Circle::new(point, 3, colour.filled())))?;
        }
        chart
            .configure_series_labels()
            .position(SeriesLabelPosition::LowerLeft)
            .label_font(("sans-serif", 11))
            .background_style(WHITE.mix(0.8))
            .draw()
    }
}

/// Whole decades around the positive values.
fn range(values: impl Iterator<Item = f64>) -> (f64, f64) {
    let (low, high) = values
        .filter(|value| *value > 0.0 && value.is_finite())
        .fold((f64::INFINITY, 0.0f64), |(low, high), value| (low.min(value), high.max(value)));
    if low > high {
        return (0.1, 10.0);
    }
    let (low, high) = (low.log10().floor(), high.log10().ceil());
    (10f64.powf(low), 10f64.powf(if high > low { high } else { low + 1.0 }))
}
