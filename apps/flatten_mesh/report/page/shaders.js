// Copyright (c) 2026 The Angle_based_flattening authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

"use strict";

// What runs on the graphics processor. The same corners are drawn on the surface and in the plane.

const TEXTURE_WIDTH = 2048; // of textures with a texel for each triangle

const CORNER_SHADER = `#version 300 es
precision highp float;
precision highp int;
uniform mat4 modelViewMatrix, projectionMatrix;
uniform bool inPlane;
in vec3 position;
in vec3 normal;
in vec2 uv;
flat out int triangle;
out vec2 place;
out vec3 direction;
void main()
{
  triangle = gl_VertexID / 3;
  place = uv;
  direction = mat3(modelViewMatrix) * normal;
  gl_Position = projectionMatrix * modelViewMatrix * vec4(inPlane ? vec3(uv, 0.0) : position, 1.0);
}`;

const FACE_SHADER = `#version 300 es
precision highp float;
precision highp int;
precision highp sampler2D;
uniform bool inPlane;
uniform sampler2D colors, faces; // one texel for each triangle
uniform float squares; // per unit of the plane; 0: none
uniform vec2 origin;
uniform int hovered, selected; // faces; -1: none
uniform vec3 highlight;
flat in int triangle;
in vec2 place;
in vec3 direction;
out vec4 color;

// The integral over stripes of width 1 that are in turn -1 and 1
vec2 wave(vec2 x) { return abs(mod(x, 2.0) - 1.0); }

// The share of light squares around a place, in an area as large as a pixel
float light_squares(vec2 place)
{
  vec2 x = squares * (place - origin), width = max(fwidth(x), 1e-5);
  vec2 stripes = (wave(x + 0.5 * width) - wave(x - 0.5 * width)) / width;
  return 0.5 - 0.5 * stripes.x * stripes.y;
}

vec4 texel(sampler2D texels)
{
  return texelFetch(texels, ivec2(triangle % ${TEXTURE_WIDTH}, triangle / ${TEXTURE_WIDTH}), 0);
}

// The number of the triangle's face, whose bytes are a colour
int face()
{
  ivec4 bytes = ivec4(round(255.0 * texel(faces)));
  return bytes.r | bytes.g << 8 | bytes.b << 16 | bytes.a << 24;
}

vec3 shaded(vec3 flat_color)
{
  vec3 normal = normalize(direction);
  normal = gl_FrontFacing ? normal : -normal;
  float light = 0.55 + 0.48 * max(dot(normal, normalize(vec3(0.2, 0.4, 1.0))), 0.0);
  vec3 seen = gl_FrontFacing ? flat_color : mix(flat_color, vec3(0.45), 0.55);
  return seen * min(light, 1.0);
}

void main()
{
  vec4 entry = texel(colors);
  vec3 result = entry.rgb;
  if(squares > 0.0 && entry.a > 0.5) {
    result = mix(result, mix(result, vec3(1.0), 0.76), light_squares(place));
  }
  if(!inPlane) {
    result = shaded(result);
  }
  int itself = face();
  if(itself == selected || itself == hovered) {
    result = highlight;
  }
  color = vec4(result, 1.0);
}`;

const NUMBER_SHADER = `#version 300 es
precision highp float;
precision highp int;
flat in int triangle;
out vec4 color;
void main()
{
  int number = triangle + 1;
  color = vec4(number & 255, (number >> 8) & 255, (number >> 16) & 255, number >> 24) / 255.0;
}`;

// A line is a rectangle of a given width in pixels, a little nearer to the eye than the surface.
const LINE_CORNER_SHADER = `#version 300 es
precision highp float;
uniform mat4 modelViewMatrix, projectionMatrix;
uniform bool inPlane;
uniform vec2 viewport; // in pixels
uniform float width, nearer, seam;
in vec2 position; // which end, which side
in vec3 from, to;
in vec2 from_uv, to_uv;
in float seam_of_line;
out float is_marked;
void main()
{
  mat4 matrix = projectionMatrix * modelViewMatrix;
  vec4 a = matrix * vec4(inPlane ? vec3(from_uv, 0.0) : from, 1.0);
  vec4 b = matrix * vec4(inPlane ? vec3(to_uv, 0.0) : to, 1.0);
  is_marked = seam >= 0.0 && seam_of_line == seam ? 1.0 : 0.0;
  vec2 along = (b.xy / b.w - a.xy / a.w) * viewport;
  along = length(along) > 0.0 ? normalize(along) : vec2(1.0, 0.0);
  float half_width = (0.5 + is_marked) * width;
  vec2 shift = half_width * (position.y * vec2(-along.y, along.x) + (2.0 * position.x - 1.0) * 0.5 * along);
  gl_Position = position.x < 0.5 ? a : b;
  gl_Position.xy += 2.0 * shift / viewport * gl_Position.w;
  gl_Position.z -= (1.0 + is_marked) * nearer * gl_Position.w;
  if(a.w <= 0.0 || b.w <= 0.0) {
    gl_Position = vec4(0.0, 0.0, 2.0, 1.0); // behind the eye
  }
}`;

const LINE_SHADER = `#version 300 es
precision highp float;
uniform vec3 line_color, highlight;
in float is_marked;
out vec4 color;
void main()
{
  color = vec4(is_marked > 0.5 ? highlight : line_color, 1.0);
}`;

// Four bytes for each triangle
function triangleTexture(triangles) {
  const rows = Math.ceil(triangles / TEXTURE_WIDTH), bytes = new Uint8Array(4 * TEXTURE_WIDTH * rows);
  return new THREE.DataTexture(bytes, TEXTURE_WIDTH, rows, THREE.RGBAFormat);
}

function unitColor(color) {
  return new THREE.Vector3(...color.map((x) => x / 255));
}

// Uniforms in `shared` are those of both views.
function faceMaterial(inPlane, shared) {
  return new THREE.RawShaderMaterial({
    vertexShader: CORNER_SHADER, fragmentShader: FACE_SHADER, side: THREE.DoubleSide,
    uniforms: {...shared, inPlane: {value: inPlane}, highlight: {value: unitColor(HIGHLIGHT)}},
    polygonOffset: !inPlane, polygonOffsetFactor: 1, polygonOffsetUnits: 1,
    depthTest: !inPlane, depthWrite: !inPlane,
  });
}

function numberMaterial(inPlane) {
  return new THREE.RawShaderMaterial({
    vertexShader: CORNER_SHADER, fragmentShader: NUMBER_SHADER, side: THREE.DoubleSide,
    uniforms: {inPlane: {value: inPlane}},
    blending: THREE.NoBlending, depthTest: !inPlane, depthWrite: !inPlane,
  });
}

function lineMaterial(inPlane, color, isOnTop) {
  return new THREE.RawShaderMaterial({
    vertexShader: LINE_CORNER_SHADER, fragmentShader: LINE_SHADER, side: THREE.DoubleSide,
    uniforms: {
      inPlane: {value: inPlane}, viewport: {value: new THREE.Vector2(1, 1)}, width: {value: 1},
      seam: {value: -1}, nearer: {value: inPlane ? 0 : isOnTop ? 4e-4 : 2e-4}, line_color: {value: unitColor(color)},
      highlight: {value: unitColor(HIGHLIGHT)},
    },
    depthTest: !inPlane, depthWrite: !inPlane,
  });
}
