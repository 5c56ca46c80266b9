//! The equations of the slides, each in the step that it belongs to.

/// The index of a step, and an equation of its slides in LaTeX.
pub const DECK: [(usize, &str); 22] = [
    (0, r"\mathbf{r}(t) = \mathbf{p} + t\mathbf{d}"),
    (0, r"t > 0"),
    (1, r"\lVert\mathbf{x}\rVert = 1 \Leftrightarrow \lVert\mathbf{x}\rVert^2 = 1"),
    (1, r"f(\mathbf{x}) = \mathbf{x} \cdot \mathbf{x} - 1 = 0"),
    (1, r"(\mathbf{p} + t\mathbf{d}) \cdot (\mathbf{p} + t\mathbf{d}) - 1 = 0"),
    (
        1,
        r"t = \frac{-\mathbf{d} \cdot \mathbf{p} \pm \sqrt{(\mathbf{d} \cdot \mathbf{p})^2 - (\mathbf{d} \cdot \mathbf{d})(\mathbf{p} \cdot \mathbf{p} - 1)}}{\mathbf{d} \cdot \mathbf{d}}",
    ),
    (
        1,
        r"t = -\mathbf{d} \cdot \mathbf{p} \pm \sqrt{(\mathbf{d} \cdot \mathbf{p})^2 - \mathbf{p} \cdot \mathbf{p} + 1}",
    ),
    (2, r"\mathbf{p} = \alpha\mathbf{a} + \beta\mathbf{b} + \gamma\mathbf{c}"),
    (2, r"\alpha + \beta + \gamma = 1"),
    (2, r"\alpha > 0; \quad \beta > 0; \quad \gamma > 0"),
    (2, r"\beta > 0; \quad \gamma > 0; \quad \beta + \gamma < 1"),
    (
        2,
        r"\mathbf{p} + t\mathbf{d} = \mathbf{a} + \beta(\mathbf{b} - \mathbf{a}) + \gamma(\mathbf{c} - \mathbf{a})",
    ),
    (
        2,
        r"\beta(\mathbf{a} - \mathbf{b}) + \gamma(\mathbf{a} - \mathbf{c}) + t\mathbf{d} = \mathbf{a} - \mathbf{p}",
    ),
    (
        2,
        r"\begin{bmatrix} \mathbf{a} - \mathbf{b} & \mathbf{a} - \mathbf{c} & \mathbf{d} \end{bmatrix} \begin{bmatrix} \beta \cr \gamma \cr t \end{bmatrix} = \mathbf{a} - \mathbf{p}",
    ),
    (
        2,
        r"\begin{bmatrix} x_a - x_b & x_a - x_c & x_d \cr y_a - y_b & y_a - y_c & y_d \cr z_a - z_b & z_a - z_c & z_d \end{bmatrix} \begin{bmatrix} \beta \cr \gamma \cr t \end{bmatrix} = \begin{bmatrix} x_a - x_p \cr y_a - y_p \cr z_a - z_p \end{bmatrix}",
    ),
    (4, r"\cos \theta = \mathbf{l} \cdot \mathbf{n}"),
    (
        6,
        r"\mathbf{h} = \mathrm{bisector}(\mathbf{v}, \mathbf{l}) = \frac{\mathbf{v} + \mathbf{l}}{\lVert\mathbf{v} + \mathbf{l}\rVert}",
    ),
    (
        6,
        r"L_s = k_s (I/r^2) \max(0, \cos \alpha)^p = k_s (I/r^2) \max(0, \mathbf{n} \cdot \mathbf{h})^p",
    ),
    (6, r"L = L_a + L_d + L_s"),
    (
        6,
        r"= k_a I_a + k_d (I/r^2) \max(0, \mathbf{n} \cdot \mathbf{l}) + k_s (I/r^2) \max(0, \mathbf{n} \cdot \mathbf{h})^p",
    ),
    (6, r"L = L_a + \sum_{i=1}^N \left[ (L_d)_i + (L_s)_i \right]"),
    (
        6,
        r"L = k_a I_a + \sum_{i=1}^N \left[ k_d (I_i/r_i^2) \max(0, \mathbf{n} \cdot \mathbf{l}_i) + k_s (I_i/r_i^2) \max(0, \mathbf{n} \cdot \mathbf{h}_i)^p \right]",
    ),
];
