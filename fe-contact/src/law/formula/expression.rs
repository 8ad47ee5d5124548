//! An expression of the overclosure with its exact derivative: dual numbers, value and slope in one pass.

/// A value and its derivative by the overclosure, from the closed side where both sides differ.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Dual {
    pub value: f64,
    pub slope: f64,
}

/// A function of one argument: its value and derivative.
pub(super) type Curve = fn(f64) -> [f64; 2];

/// What a formula may call.
#[derive(Clone, Copy, Debug)]
pub(super) enum Function {
    /// Of one argument.
    Curve(Curve),
    /// The size of one argument.
    Abs,
    /// Of two arguments.
    Join(Operator),
    /// `a < b, one, other`.
    If,
}

/// The functions by name.
pub(super) const FUNCTIONS: &[(&str, Function)] = &[
    ("exp", Function::Curve(|x| [x.exp(); 2])),
    ("log", Function::Curve(|x| [x.ln(), 1.0 / x])),
    ("sqrt", Function::Curve(|x| [x.sqrt(), 0.5 / x.sqrt()])),
    ("sin", Function::Curve(|x| [x.sin(), x.cos()])),
    ("cos", Function::Curve(|x| [x.cos(), -x.sin()])),
    ("tan", Function::Curve(|x| [x.tan(), 1.0 + x.tan() * x.tan()])),
    ("tanh", Function::Curve(|x| [x.tanh(), 1.0 / (x.cosh() * x.cosh())])),
    ("atan", Function::Curve(|x| [x.atan(), 1.0 / (1.0 + x * x)])),
    ("abs", Function::Abs),
    ("min", Function::Join(Operator::Min)),
    ("max", Function::Join(Operator::Max)),
    ("if", Function::If),
];

/// What joins two arguments.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Operator {
    Add,
    Subtract,
    Multiply,
    Divide,
    Power,
    Min,
    Max,
}

/// An expression of the overclosure h.
#[derive(Clone, Debug)]
pub(super) enum Node {
    Number(f64),
    Overclosure,
    Abs(Box<Node>),
    Apply(Curve, Box<Node>),
    Join(Operator, Box<[Node; 2]>),
    /// The third where the first is less than the second, else the fourth.
    If(Box<[Node; 4]>),
}

impl Node {
    /// Value and slope at an overclosure.
    pub fn at(&self, h: f64) -> Dual {
        match self {
            Node::Number(value) => Dual { value: *value, slope: 0.0 },
            Node::Overclosure => Dual { value: h, slope: 1.0 },
            Node::Abs(inner) => {
                let x = inner.at(h);
                if less(x, Dual { value: 0.0, slope: 0.0 }) { Dual { value: -x.value, slope: -x.slope } } else { x }
            }
            Node::Apply(curve, inner) => {
                let x = inner.at(h);
                let [value, derivative] = curve(x.value);
                Dual { value, slope: chain(derivative, x.slope) }
            }
            Node::Join(operator, two) => join(*operator, two[0].at(h), two[1].at(h)),
            Node::If(four) => four[if less(four[0].at(h), four[1].at(h)) { 2 } else { 3 }].at(h),
        }
    }

    /// The number it is whatever the overclosure.
    pub fn number(&self) -> Option<f64> {
        if let Node::Number(value) = self { Some(*value) } else { None }
    }

    /// Itself, or its number where its arguments are numbers.
    pub fn folded(self) -> Node {
        if self.children().iter().all(|child| child.number().is_some()) && !matches!(self, Node::Overclosure) {
            return Node::Number(self.at(0.0).value);
        }
        self
    }

    /// The number of its operations and numbers.
    pub fn size(&self) -> usize {
        1 + self.children().iter().map(Node::size).sum::<usize>()
    }

    /// The differences whose sign decides between two branches.
    pub fn switches(&self) -> Vec<Node> {
        let mut all: Vec<Node> = self.children().iter().flat_map(Node::switches).collect();
        let difference = |two: &[Node]| Node::Join(Operator::Subtract, Box::new([two[0].clone(), two[1].clone()]));
        match self {
            Node::Abs(inner) => all.push((**inner).clone()),
            Node::Join(Operator::Min | Operator::Max, two) => all.push(difference(&two[..])),
            Node::If(four) => all.push(difference(&four[..2])),
            _ => {}
        }
        all
    }

    fn children(&self) -> &[Node] {
        match self {
            Node::Number(_) | Node::Overclosure => &[],
            Node::Abs(inner) | Node::Apply(_, inner) => std::slice::from_ref(inner),
            Node::Join(_, two) => &two[..],
            Node::If(four) => &four[..],
        }
    }
}

/// Less here, or a little deeper.
fn less(a: Dual, b: Dual) -> bool {
    a.value < b.value || (a.value == b.value && a.slope < b.slope)
}

/// A constant stays one, even where a derivative is infinite.
fn chain(derivative: f64, slope: f64) -> f64 {
    if slope == 0.0 { 0.0 } else { derivative * slope }
}

fn join(operator: Operator, a: Dual, b: Dual) -> Dual {
    let (value, slope) = match operator {
        Operator::Add => (a.value + b.value, a.slope + b.slope),
        Operator::Subtract => (a.value - b.value, a.slope - b.slope),
        Operator::Multiply => (a.value * b.value, chain(b.value, a.slope) + chain(a.value, b.slope)),
        Operator::Divide => {
            let value = a.value / b.value;
            (value, (a.slope - chain(value, b.slope)) / b.value)
        }
        Operator::Power => {
            let value = a.value.powf(b.value);
            let of_base = if b.value == 0.0 { 0.0 } else { b.value * a.value.powf(b.value - 1.0) };
            (value, chain(of_base, a.slope) + chain(value * a.value.ln(), b.slope))
        }
        Operator::Min => return if less(b, a) { b } else { a },
        Operator::Max => return if less(a, b) { b } else { a },
    };
    Dual { value, slope }
}
