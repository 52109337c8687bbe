import { lightThrough } from './shadow.js';

/**
 * A segment of a strand becomes a ribbon that faces the viewer: a cubic through the vertices in
 * STEPS steps, as wide as the strand, but at least about a pixel. There are no attributes: the
 * number of a corner says which segment and step it belongs to.
 */
export const strandVertex = /* glsl */ `
uniform highp sampler2D moving;   // of each vertex x, y, z, value
uniform highp sampler2D constant;  // radius; whether it has one before (1), two behind (2); random

uniform float viewHeight;  // pixels
uniform float widening;

out vec3 world, tangent, side, towardsViewer;
out float across, value, coverage, random;

vec4 at(highp sampler2D texels, int vertex) {
  int width = textureSize(texels, 0).x;
  return texelFetch(texels, ivec2(vertex % width, vertex / width), 0);
}

void main() {
  const int corners = 2 * (STEPS + 1);
  int vertex = gl_VertexID / corners, corner = gl_VertexID % corners;
  float s = float(corner / 2) / float(STEPS);
  across = float(2 * (corner % 2) - 1);

  vec4 here = at(moving, vertex), next = at(moving, vertex + 1);
  vec4 constants = at(constant, vertex);
  int neighbours = int(constants.y);
  vec3 from = here.xyz, to = next.xyz;
  vec3 slopeFrom = (neighbours & 1) != 0 ? 0.5 * (to - at(moving, vertex - 1).xyz) : to - from;
  vec3 slopeTo = (neighbours & 2) != 0 ? 0.5 * (at(moving, vertex + 2).xyz - from) : to - from;
  vec3 bend = 2.0 * (from - to) + slopeFrom + slopeTo;
  vec3 turn = 3.0 * (to - from) - 2.0 * slopeFrom - slopeTo;
  vec3 centre = from + s * (slopeFrom + s * (turn + s * bend));
  vec3 direction = slopeFrom + s * (2.0 * turn + 3.0 * s * bend);

  vec4 seen = viewMatrix * vec4(centre, 1.0);
  vec3 viewer = isOrthographic ? vec3(0.0, 0.0, 1.0) : normalize(-seen.xyz);
  vec3 viewTangent = normalize(mat3(viewMatrix) * direction + 1e-12);
  vec3 viewSide = cross(viewTangent, viewer);
  viewSide /= max(length(viewSide), 0.05);

  float distance = isOrthographic ? 1.0 : -seen.z;
  float pixel = 2.0 * distance / (projectionMatrix[1][1] * viewHeight);
  float radius = widening * mix(constants.x, at(constant, vertex + 1).x, s);
  float drawn = max(radius, 0.6 * pixel);
  coverage = clamp(radius / drawn, 0.15, 1.0);
  gl_Position = projectionMatrix * vec4(seen.xyz + across * drawn * viewSide, 1.0);

  mat3 toWorld = transpose(mat3(viewMatrix));
  world = centre;
  tangent = toWorld * viewTangent;
  side = toWorld * viewSide;
  towardsViewer = toWorld * viewer;
  value = mix(here.w, next.w, s);
  random = constants.z;
}
`;

/** Light on hair after Kajiya and Kay 1989, two highlights as in Marschner et al. 2003. */
export const strandFragment = /* glsl */ `
in vec3 world, tangent, side, towardsViewer;
in float across, value, coverage, random;

uniform sampler2D scale;
uniform vec2 range;
uniform int colouring;  // 0 hair, 1 the number of the strand, 2 a scale
uniform float thickness;  // of hair that swallows light, m
uniform float bias;       // m
${lightThrough}
out vec4 colour;

float hash(float n) { return fract(sin(n) * 43758.5453); }
float noise(float x) {
  float whole = floor(x);
  return mix(hash(whole), hash(whole + 1.0), smoothstep(0.0, 1.0, x - whole));
}

// Of a strand that is wide on the screen single hairs show.
float hairs() {
  float place = 4.0 * across + 57.0 * random;
  float width = fwidth(place);
  return mix(noise(place) + 0.5 * noise(3.1 * place) - 0.75, 0.0, smoothstep(0.4, 1.5, width));
}

vec3 base() {
  if (colouring == 0) {
    return mix(vec3(0.115, 0.056, 0.030), vec3(0.190, 0.098, 0.052), random);
  }
  float place = colouring == 1 ? random : (value - range.x) / (range.y - range.x);
  vec3 seen = texture(scale, vec2(clamp(place, 0.002, 0.998), 0.5)).rgb;
  return pow(seen, vec3(2.2));
}

float highlight(vec3 t, vec3 halfway, float exponent) {
  float cosine = dot(t, halfway);
  return pow(sqrt(max(0.0, 1.0 - cosine * cosine)), exponent);
}

void main() {
  vec3 t = normalize(tangent), viewer = normalize(towardsViewer);
  float round = sqrt(max(0.0, 1.0 - across * across));
  vec3 normal = normalize(normalize(side) * across + viewer * round);
  vec3 light = lightDirection;
  float fibre = hairs();

  float cosine = dot(t, light);
  float sine = sqrt(max(0.0, 1.0 - cosine * cosine));
  float facing = 0.5 + 0.5 * dot(normal, light);
  float through = lightThrough(world + normal * bias, bias, thickness);

  vec3 halfway = normalize(light + viewer);
  vec3 albedo = base() * (1.0 + 0.7 * fibre);
  float white = highlight(normalize(t + (0.10 + 0.25 * fibre) * normal), halfway, 90.0);
  float coloured = highlight(normalize(t + (-0.16 + 0.25 * fibre) * normal), halfway, 24.0);

  float sky = 0.5 + 0.5 * normal.y;
  vec3 ambient = mix(vec3(0.30, 0.27, 0.25), vec3(0.55, 0.60, 0.70), sky) * mix(0.45, 1.0, through);
  float rim = pow(1.0 - round, 2.0) * 0.25;
  float shine = colouring == 0 ? 1.0 : 0.35;
  vec3 lit = albedo * (ambient + 1.5 * through * sine * facing + rim)
           + shine * through * facing * (0.13 * white * vec3(1.0, 0.95, 0.88)
                                         + 1.1 * coloured * albedo);
  lit *= mix(0.55, 1.0, smoothstep(0.0, 0.65, round));
  colour = vec4(lit, coverage);
  colour = vec4(pow(clamp(colour.rgb, 0.0, 1.0), vec3(1.0 / 2.2)), colour.a);
}
`;

/** For the shadow only the depth counts. */
export const shadowFragment = /* glsl */ `
out vec4 colour;
void main() { colour = vec4(1.0); }
`;
