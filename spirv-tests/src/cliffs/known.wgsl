// What filters know of a ray: where it ends on the ground as the pixel's footprint leaves it, and the statistics of
// what the footprint loses there. One invocation a ray.

struct Ray {
    // Where it comes under the highest ground, and a unit vector on from there.
    origin: vec3f,
    way: vec3f,
    // Width of its pixel there, and how much that grows a meter.
    width: f32,
    growth: f32,
}

const numbers = 8u;
const results = 8u;

@group(0) @binding(0) var<storage, read_write> found: array<f32>;
@group(0) @binding(1) var<storage, read> rays: array<f32>;
// Meters from texel to texel, size of a face in meters, deviation of the footprint for a pixel one meter wide.
@group(0) @binding(2) var<storage, read> ground: array<f32>;
@group(1) @binding(0) var heights: texture_2d<f32>;
@group(1) @binding(1) var heights_sampler: sampler;
@group(1) @binding(2) var slopes: texture_2d<f32>;
@group(1) @binding(3) var slopes_sampler: sampler;
@group(1) @binding(4) var slopes_cross: texture_2d<f32>;

fn spacing() -> vec2f {
    return vec2f(ground[0], ground[1]);
}

// Texture coordinates: the first texel's center is at the origin.
fn position(place: vec2f) -> vec2f {
    return (place / spacing() + 0.5) / vec2f(textureDimensions(heights, 0));
}

// Covariance of the places that a pixel of a width covers, in texels². A pixel thinner than a face sees one, which is
// turned to it: the footprint is as long as wide. A thicker one sees many, over all the level ground that it covers.
fn footprint(ray: Ray, width: f32) -> vec3f {
    let many = width / sqrt(width * width + ground[2] * ground[2]);
    let long = many * ray.way.xy / ray.way.z;
    let deviation = ground[3] * width / spacing();
    return (vec3f(1.0, 0.0, 1.0) + long.xxy * long.xyy) * deviation.xxy * deviation.xyy;
}

fn height(ray: Ray, along: f32) -> f32 {
    let place = ray.origin.xy + along * ray.way.xy;
    let covers = footprint(ray, ray.width + along * ray.growth);
    return moments_read(heights, heights_sampler, position(place), covers).x;
}

// How far a ray is above the ground.
fn over(ray: Ray, along: f32) -> f32 {
    return ray.origin.z + along * ray.way.z - height(ray, along);
}

// Along the ray to the ground, by steps that a slope of 1 cannot pass.
fn hit(ray: Ray) -> f32 {
    let closing = length(ray.way.xy) - ray.way.z;
    var above = 0.0;
    var below = 0.0;
    for (var step = 0u; step < 500u; step += 1u) {
        let gap = over(ray, below);
        if gap <= 0.0 {
            break;
        }
        above = below;
        below += max(gap / closing, 0.25 * ground[0]);
    }
    for (var halving = 0u; halving < 10u; halving += 1u) {
        let middle = 0.5 * (above + below);
        let outside = over(ray, middle) > 0.0;
        above = select(above, middle, outside);
        below = select(middle, below, outside);
    }
    return 0.5 * (above + below);
}

@compute @workgroup_size(64)
fn main(@builtin(global_invocation_id) id: vec3u, @builtin(num_workgroups) groups: vec3u) {
    let index = id.x + id.y * groups.x * 64u;
    if numbers * index >= arrayLength(&rays) {
        return;
    }
    let at = numbers * index;
    let origin = vec3f(rays[at], rays[at + 1u], rays[at + 2u]);
    let way = vec3f(rays[at + 3u], rays[at + 4u], rays[at + 5u]);
    let ray = Ray(origin, way, rays[at + 6u], rays[at + 7u]);
    let along = hit(ray);
    let place = position(origin.xy + along * way.xy);
    let covers = footprint(ray, ray.width + along * ray.growth);
    let h = moments_read(heights, heights_sampler, place, covers);
    let s = slope_moments_read(slopes, slopes_cross, slopes_sampler, place, covers);
    // From meters a texel to meters a meter.
    let scale = 1.0 / spacing();
    let mean = s.mean * scale;
    let covariance = s.covariance * scale.xxy * scale.xyy;
    let first = results * index;
    found[first] = h.x;
    found[first + 1u] = h.y;
    found[first + 2u] = mean.x;
    found[first + 3u] = mean.y;
    found[first + 4u] = covariance.x;
    found[first + 5u] = covariance.y;
    found[first + 6u] = covariance.z;
    found[first + 7u] = along;
}
