"""The method's equations and assumptions, as Typst's source (CONVENTIONS.md, "Height")."""

METHOD = r"""
#let eq(alt, body) = block(width: measure, math.equation(block: true, numbering: "(1)", alt: alt, body))
#let m(alt, body) = math.equation(block: false, alt: alt, body)
#let says(body) = block(width: measure, body)

#let misprints = (
  ("(3)",
    m("lambda p = K d([R t] X)", $lambda bold(p) = K thin d([R med bold(t)] bold(X))$),
    [the distortion acts after the division by depth, equation (1)]),
  ("(4)",
    m("p = d inverse of K inverse P", $bold(p) = d^(-1)(K^(-1) bold(P))$),
    [the pixel is what is undistorted, equation (2)]),
  ("(5)–(7)",
    m("n = [R t] e", $bold(n) = [R med bold(t)] bold(e)$),
    [directions rotate and are not shifted, #m("n = R e", $bold(n) = R bold(e)$)]),
  ("(8)",
    m("X g = t + h n x", $bold(X)_g = bold(t) + h bold(n)_x$),
    [right only where #m("n x", $bold(n)_x$) points down; corners are put into that order first]),
  ("(14), (15)",
    m("d = n z transposed p l", $d = bold(n)_z^top bold(p)_l$),
    [#m("d = minus n z transposed p l", $d = -bold(n)_z^top bold(p)_l$), otherwise the side plane is
    mirrored]),
  ("(17)",
    m("n x p prime l over n x p prime h", $bold(n)_x bold(p)'_l \/ bold(n)_x bold(p)'_h$),
    [#m("n z transposed p l over n z transposed p prime h",
      $bold(n)_z^top bold(p)_l \/ bold(n)_z^top bold(p)'_h$), with the metric contact point]),
  ("(18)",
    m("p h transposed P g over minus n x", $bold(p)_h^top P_g \/ (-bold(n)_x)$),
    [the signed distance from the road plane, #m("n x transposed (X g minus p h)",
      $bold(n)_x^top (bold(X)_g - bold(p)_h)$)]),
)

#let method-block() = {
  says[
    Heights are measured as Dupuis et al. (Sensors 2019, 19(7), 1611, “the paper”) propose, with the
    misprints of its
    equations mended (below). A checkerboard of known size that stands on the road gives the camera’s pose;
    two clicks
    on one frame, where a tyre meets the road and on the target, give a height. The road frame has X along the
    traffic, Y across it and away from the camera, and Z up. A point #m("x", $bold(x)$) of the road is seen
    at the pixel
  ]
  eq("p = K d(pi(R x + t)), pi(x, y, z) = (x over z, y over z)",
    $bold(p) = K thin d(pi(R bold(x) + bold(t))), quad pi(x, y, z) = (x\/z, y\/z),$)
  says[
    where #m("R, t", $R, bold(t)$) is the pose, #m("d", $d$) the lens’s distortion (Brown’s radial and
    tangential model,
    or the equidistant fisheye) and #m("K", $K$) holds focal lengths and principal point. A click #m("p",
    $bold(p)$)
    is turned back into a direction of the road frame, seen from the camera’s centre #m("C", $bold(C)$):
  ]
  eq("m = d inverse of K inverse p, w = R transposed (m x, m y, 1), C = minus R transposed t",
    $bold(m) = d^(-1)(K^(-1) bold(p)), quad bold(w) = R^top (m_x, m_y, 1)^top,
      quad bold(C) = -R^top bold(t).$)
  says[
    The contact’s ray meets the road, #m("Z = 0", $Z = 0$). The target’s ray meets the vertical plane along
    the traffic
    that lies the inset #m("delta", $delta$) behind the contact. With one slope from each click,
  ]
  eq("s = w y over w z at the contact, q = w z over w y at the target",
    $s = lr((w_y / w_z) |)_"contact", quad q = lr((w_z / w_y) |)_"target",$)
  says[the distance #m("D", $D$) from the camera to the contact’s plane and the height #m("h", $h$) are]
  eq("D = minus C z s, h = C z + (D + delta) q",
    $D = -C_z s, quad h = C_z + (D + delta) thin q.$)
  says[
    The paper takes #m("delta = 0", $delta = 0$), which reads a target at #m("h", $h$) too high by
  ]
  eq("b = (C z minus h) delta over (D + delta)", $b = (C_z - h) thin delta / (D + delta),$)
  says[
    44 mm for an eye at 1.16 m, 0.45 m inboard, 3 m from a camera 1.5 m high. Heights are therefore given
    twice: “raw”
    with #m("delta = 0", $delta = 0$), to be compared with the paper, and corrected by the inset below.
    Where the same
    two points were clicked on several frames of a pass, the inset is solved for with the height by least
    squares.
  ]
  says[
    Each height carries its standard uncertainty by linear propagation (JCGM 100:2008),
  ]
  eq("u squared of h = sum over i of (dh by dx i) squared u squared of x i, U 95 = 1.96 u of h",
    $u^2(h) = sum_i ((partial h) / (partial x_i))^2 u^2(x_i), quad U_95 = 1.96 thin u(h),$)
  says[
    over both clicks, lens and pose (jointly, with their covariance), the board’s lean, roll, height above
    the road, square
    size and bow, and the inset. The same pose serves many vehicles: what it is off by, all its heights share.
  ]
  heading(level: 2, numbering: none)[What is assumed]
  block(width: measure, list(marker: [–],
    [The road is a plane from the board to the vehicle, and the board stood square to it within its stated
    uncertainty.],
    [The camera did not move between the board’s recording and the measurements that rest on it.],
    [Vehicles travel parallel to the board’s rows; their sides are upright at the contact.],
    [The inset of a target is that of the list below, within its uncertainty, unless several frames gave it.],
    [Manufacturers’ heights hold for the vehicle as it drove by, within their stated uncertainty.],
    [Left out: a wrong lens model, load and springs, camber between board and vehicle.],
  ))
  heading(level: 2, numbering: none)[Where the paper is misprinted]
  set text(size: 9pt)
  set par(leading: 0.55em)
  figure(kind: table, caption: [Equations of the paper as printed, and as used here.], align(left, table(
    columns: (18mm, 44mm, 1fr),
    align: left + horizon, stroke: none,
    inset: (x, y) => (left: if x == 0 { 0pt } else { 4.5pt }, right: 4.5pt, top: 4pt, bottom: 4pt),
    table.hline(stroke: 0.8pt + ink),
    table.header(repeat: true, ..([Equation], [As printed], [As used]).map(t => text(weight: 600, size:
    8.5pt, t))),
    table.hline(stroke: 0.4pt + ink),
    ..misprints.flatten(),
    table.hline(stroke: 0.8pt + ink),
  )))
}
"""
