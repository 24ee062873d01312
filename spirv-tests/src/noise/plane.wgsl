// A plane to the horizon, one unit below the eye: `plane_scene` of examples/data/colormaps.json.

alias Place = vec2f;

fn seen(pixel: vec2f) -> Seen {
    let near = shot.density / pixel.y;
    let ground = near * vec2f(pixel.x, shot.focal);
    return Seen(shot.origin.xy + ground, vec2f(near, 0.0), -ground / pixel.y, true, 1.0);
}
