//! The manual, printed from the keyword tables.

use crate::deck::card::normalized;
use crate::deck::nearest::nearest;
use crate::keyword::{
    CARDS, Data, DataLine, Field, Keyword, Kind, Known, Level, Parameter, Repeat, Standing, find, names,
};
use crate::keyword::{row::of_law, table::FieldKind};
use fe_contact::law::{Laws, Lines};
use std::fmt::Write;

/// All cards, a line each.
pub fn list() -> String {
    let mut out = String::new();
    for card in CARDS {
        line(&mut out, &format!("*{:<20} {}", card.name, card.summary));
    }
    line(&mut out, "");
    line(&mut out, "`fe keywords CARD` shows one in full. Case and blanks inside keywords do not count.");
    out
}

/// One card in full, by its name with or without the star; `Err` says what is known instead.
pub fn card(name: &str, laws: &Laws) -> Result<String, String> {
    let name = normalized(name.trim_start_matches('*'));
    match find(&name) {
        Some(Known::Card(card)) => Ok(full(card, laws)),
        Some(Known::NotYet(name, instead)) => Ok(format!("*{name} is not there yet; {instead}\n")),
        Some(Known::Idle(name, why)) => Ok(format!("*{name} is read and has no effect; {why}\n")),
        None => Err(match nearest(&name, names()) {
            Some(near) => format!("*{name} is not a known card; did you mean *{near}?"),
            None => format!("*{name} is not a known card; `fe keywords` lists them"),
        }),
    }
}

fn line(out: &mut String, text: &str) {
    out.push_str(text.trim_end());
    out.push('\n');
}

fn full(card: &Keyword, laws: &Laws) -> String {
    let mut out = String::new();
    let level = match card.level {
        Level::Model => "model data, before the first step",
        Level::Part => "model data, before the first step; also in a part, an instance or the assembly",
        Level::Assembly => "model data, in the assembly",
        Level::Step => "in a step",
        Level::Either => "model data, or in a step",
        Level::Anywhere => "model data, also in a part, an instance or the assembly; or in a step",
    };
    line(&mut out, &format!("*{}: {}", card.name, card.summary));
    line(&mut out, &format!("  {level}"));
    parameters(&mut out, card, laws);
    data(&mut out, card, laws);
    line(&mut out, "");
    line(&mut out, &format!("Source: {}", card.source));
    out
}

fn parameters(out: &mut String, card: &Keyword, laws: &Laws) {
    let there: Vec<&Parameter> = card.parameters.iter().filter(|p| p.standing == Standing::There).collect();
    if !there.is_empty() {
        line(out, "\nParameters");
    }
    for parameter in there {
        let alias = parameter.alias.map_or(String::new(), |alias| format!(" (or {alias})"));
        let required = if parameter.required { ", required" } else { "" };
        line(out, &format!("  {}{}{alias}{required}", parameter.name, value(parameter.kind)));
        line(out, &format!("      {}", parameter.meaning));
        if let Kind::Choice(words) | Kind::OptionalChoice(words) | Kind::Law(words) = parameter.kind {
            let mut known = Vec::new();
            if matches!(parameter.kind, Kind::Law(_)) {
                known.push("HARD");
                known.extend(laws.0.iter().map(|law| law.keyword));
            }
            known.extend(words.iter().filter(|w| w.standing == Standing::There).map(|w| w.word));
            line(out, &format!("      one of: {}", known.join(", ")));
            let absent = words.iter().filter(|w| w.standing != Standing::There && !known.contains(&w.word));
            let absent: Vec<&str> = absent.map(|w| w.word).collect();
            if !absent.is_empty() {
                line(out, &format!("      not there yet: {}", absent.join(", ")));
            }
        }
    }
    for (heading, instead) in [("Not there yet", true), ("Without effect", false)] {
        let others: Vec<(&str, &str)> = card.parameters.iter().filter_map(|p| other(p, instead)).collect();
        if !others.is_empty() {
            line(out, &format!("\n{heading}"));
        }
        for (name, why) in others {
            line(out, &format!("  {name}: {why}"));
        }
    }
}

fn other(parameter: &Parameter, not_yet: bool) -> Option<(&'static str, &'static str)> {
    match parameter.standing {
        Standing::NotYet(instead) if not_yet => Some((parameter.name, instead)),
        Standing::Idle(why) if !not_yet => Some((parameter.name, why)),
        Standing::Silent if !not_yet => Some((parameter.name, parameter.meaning)),
        _ => None,
    }
}

fn value(kind: Kind) -> &'static str {
    match kind {
        Kind::Flag => "",
        Kind::Any | Kind::OptionalChoice(_) => "[=…]",
        Kind::Number => "=number",
        Kind::Whole => "=whole number",
        Kind::Name | Kind::Text => "=…",
        Kind::Choice(_) | Kind::Law(_) => "=word",
    }
}

fn data(out: &mut String, card: &Keyword, laws: &Laws) {
    match card.data {
        Data::None => {}
        Data::Text(what) => line(out, &format!("\nData: {what}")),
        Data::Lines(lines) => {
            lines.iter().filter(|l| !l.fields.is_empty()).for_each(|l| data_line(out, l));
            if card.parameters.iter().any(|p| matches!(p.kind, Kind::Law(_))) {
                laws.0.iter().for_each(|law| {
                    let lines = match law.lines {
                        Lines::One => "Data line".to_owned(),
                        Lines::AtLeast(least) => format!("Data lines, {least} or more"),
                    };
                    line(out, &format!("\n{lines}, PRESSURE-OVERCLOSURE={}: {}", law.keyword, law.summary));
                    law.data.iter().for_each(|datum| field(out, &of_law(datum)));
                    line(out, &format!("  Source: {}", law.source));
                });
            }
        }
    }
}

fn data_line(out: &mut String, data: &DataLine) {
    let repeat = match data.repeat {
        Repeat::Once => "Data line",
        Repeat::Optional => "Data line, may be left out",
        Repeat::Many => "Data lines",
    };
    let when = if data.when.is_empty() { String::new() } else { format!(" ({})", data.when) };
    line(out, &format!("\n{repeat}{when}"));
    data.fields.iter().filter(|f| !f.meaning.is_empty()).for_each(|f| field(out, f));
}

fn field(out: &mut String, field: &Field) {
    let mut text = format!("  {}", field.name);
    if !field.dimension.is_empty() {
        let _ = write!(text, " [{}]", field.dimension);
    }
    let _ = write!(text, ": {}", field.meaning);
    let range = if field.kind == FieldKind::Word { String::new() } else { field.range() };
    if !range.is_empty() {
        let _ = write!(text, "; {range}");
    }
    if !field.required {
        let _ = write!(text, "; blank: {}", field.blank);
    }
    line(out, &text);
}
