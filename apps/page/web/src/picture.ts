// SPDX-License-Identifier: Apache-2.0
// Draws the scene once, or once per eye. Then ambient occlusion darkens cavities, so that their depth is visible.
import * as three from "three";
import { offAxisFrustum } from "./geometry.ts";

export type Stereo = "off" | "side-by-side" | "anaglyph";

const screenVertex = `
out vec2 at;
void main() { at = uv; gl_Position = vec4(position.xy, 0.0, 1.0); }`;

// Ambient occlusion from twelve points around each pixel.
const occlusionFragment = `
uniform sampler2D depth;
uniform mat4 unproject;
uniform vec2 pixel;
uniform float near, far, radius, perUnit;
in vec2 at;
out vec4 color;
float distanceAt(vec2 p) {
  float z = texture(depth, p).r;
  return near * far / (far - z * (far - near));
}
vec3 placeAt(vec2 p, float d) { return vec3((p * 2.0 - 1.0) * vec2(unproject[0][0], unproject[1][1]) * d, -d); }
void main() {
  float d = distanceAt(at);
  if (d > 0.98 * far) { color = vec4(1.0); return; }
  vec3 place = placeAt(at, d);
  vec3 right = placeAt(at + vec2(pixel.x, 0.0), distanceAt(at + vec2(pixel.x, 0.0))) - place;
  vec3 left = place - placeAt(at - vec2(pixel.x, 0.0), distanceAt(at - vec2(pixel.x, 0.0)));
  vec3 up = placeAt(at + vec2(0.0, pixel.y), distanceAt(at + vec2(0.0, pixel.y))) - place;
  vec3 down = place - placeAt(at - vec2(0.0, pixel.y), distanceAt(at - vec2(0.0, pixel.y)));
  vec3 normal = normalize(cross(abs(right.z) < abs(left.z) ? right : left, abs(up.z) < abs(down.z) ? up : down));
  float phase = 6.2832 * fract(52.9829189 * fract(dot(gl_FragCoord.xy, vec2(0.06711056, 0.00583715))));
  float closed = 0.0;
  for (int n = 0; n < 12; ++n) {
    float fraction = (float(n) + 0.5) / 12.0, angle = phase + 2.4 * float(n);
    vec2 p = at + vec2(cos(angle), sin(angle)) * sqrt(fraction) * radius * perUnit / d * vec2(pixel.x / pixel.y, 1.0);
    vec3 to = placeAt(p, distanceAt(p)) - place;
    float away = length(to);
    closed += max(0.0, dot(normal, to) / max(away, 1e-4) - 0.15) * smoothstep(1.3 * radius, 0.3 * radius, away);
  }
  color = vec4(vec3(clamp(1.0 - 1.55 * closed / 12.0, 0.0, 1.0)), 1.0);
}`;

const finishFragment = `
uniform sampler2D left, right, shade, shadeRight;
uniform vec2 pixel;
uniform bool anaglyph, shaded;
in vec2 at;
out vec4 color;
float shadeAt(sampler2D map) {
  if (!shaded) return 1.0;
  float sum = 0.0;
  for (int x = -1; x <= 2; ++x)
    for (int y = -1; y <= 2; ++y) sum += texture(map, at + (vec2(x, y) - 0.5) * pixel).r;
  return sum / 16.0;
}
vec3 shown(vec3 c) { return pow(clamp(c, 0.0, 1.0), vec3(1.0 / 2.2)); }
void main() {
  vec3 one = shown(texture(left, at).rgb * shadeAt(shade));
  if (anaglyph) {
    vec3 other = shown(texture(right, at).rgb * shadeAt(shadeRight));
    one = vec3(dot(one, vec3(0.30, 0.59, 0.11)), other.gb);
  }
  color = vec4(one, 1.0);
}`;

interface EyeTarget {
  color: three.WebGLRenderTarget;
  shade: three.WebGLRenderTarget;
}

export class Picture {
  readonly renderer: three.WebGLRenderer;
  stereo: Stereo = "off";
  eyeDistance = 3; // mm, in the object's units
  convergence = 60; // mm
  occlusion = true;
  software: boolean;
  softwareRatio = 0.75; // ratio of drawn to shown pixels without a graphics card
  private eyes: EyeTarget[] = [];
  private gl: WebGL2RenderingContext;
  private pending: { fence: WebGLSync; since: number } | null = null; // the picture that is not yet finished
  private lastDuration = 0; // ms, of the last picture
  private screen = new three.Scene();
  private flat = new three.Camera();
  private quad = new three.Mesh(new three.PlaneGeometry(2, 2));
  private occlude = new three.ShaderMaterial({
    glslVersion: three.GLSL3, vertexShader: screenVertex, fragmentShader: occlusionFragment, depthTest: false,
    uniforms: {
      depth: { value: null }, unproject: { value: new three.Matrix4() }, pixel: { value: new three.Vector2() },
      near: { value: 1 }, far: { value: 10 }, radius: { value: 2 }, perUnit: { value: 1 },
    },
  });
  private finish = new three.ShaderMaterial({
    glslVersion: three.GLSL3, vertexShader: screenVertex, fragmentShader: finishFragment, depthTest: false,
    uniforms: {
      left: { value: null }, right: { value: null }, shade: { value: null }, shadeRight: { value: null },
      pixel: { value: new three.Vector2() }, anaglyph: { value: false }, shaded: { value: true },
    },
  });
  private eye = new three.PerspectiveCamera();

  constructor(canvas: HTMLCanvasElement) {
    this.renderer = new three.WebGLRenderer({ canvas, antialias: false, preserveDrawingBuffer: true });
    this.renderer.outputColorSpace = three.LinearSRGBColorSpace; // the last pass applies the gamma
    this.quad.frustumCulled = false;
    this.screen.add(this.quad);
    const gl = (this.gl = this.renderer.getContext() as WebGL2RenderingContext);
    const names = gl.getExtension("WEBGL_debug_renderer_info");
    this.software = /swiftshader|llvmpipe|software/i.test(
      String(gl.getParameter(names ? names.UNMASKED_RENDERER_WEBGL : gl.RENDERER)));
  }

  /** The number of pictures side by side. */
  get columns(): number { return this.stereo === "side-by-side" ? 2 : 1; }
  get size(): three.Vector2 { return this.renderer.getDrawingBufferSize(new three.Vector2()); }

  /** @param width  of the canvas on the page */
  resize(width: number, height: number) {
    this.renderer.setPixelRatio(this.software ? this.softwareRatio : Math.min(2, devicePixelRatio));
    this.renderer.setSize(width, height, false);
    for (const eye of this.eyes) {
      eye.color.dispose();
      eye.shade.dispose();
    }
    this.eyes = [];
  }

  /**
   * [ms] The pause between pictures. Without a graphics card, a picture begins only after the last one is finished and
   * after a pause as long as that picture took. Otherwise pictures would queue up and block the browser.
   */
  pause(now: number): number {
    if (!this.software) return 0;
    if (this.pending) {
      const { fence, since } = this.pending;
      if (this.gl.getSyncParameter(fence, this.gl.SYNC_STATUS) === this.gl.UNSIGNALED) return Infinity; // null: lost
      this.gl.deleteSync(fence);
      this.lastDuration = now - since;
      this.pending = null;
    }
    return Math.max(250, 2 * this.lastDuration);
  }

  draw(scene: three.Scene, camera: three.PerspectiveCamera, radius: number) {
    this.drawEyes(scene, camera, radius);
    if (!this.software) return;
    const fence = this.gl.fenceSync(this.gl.SYNC_GPU_COMMANDS_COMPLETE, 0);
    if (fence) this.pending = { fence, since: performance.now() };
    this.gl.flush();
  }

  private drawEyes(scene: three.Scene, camera: three.PerspectiveCamera, radius: number) {
    const { x: width, y: height } = this.size;
    if (this.stereo === "off") {
      this.render(0, scene, camera, width, height, radius);
      this.show(0, 0, 0, 0, width, height);
      return;
    }
    const half = Math.floor(width / this.columns);
    for (const n of [0, 1]) this.render(n, scene, this.eyeOf(camera, n === 0 ? -1 : 1), half, height, radius);
    if (this.stereo === "anaglyph") {
      this.show(0, 1, 0, 0, width, height);
    } else {
      this.show(0, 0, 0, 0, half, height);
      this.show(1, 1, half, 0, half, height);
    }
  }

  /** @param side  -1: the left eye, 1: the right */
  eyeOf(camera: three.PerspectiveCamera, side: number): three.PerspectiveCamera {
    const offset = (side * this.eyeDistance) / 2;
    const f = offAxisFrustum((camera.fov * Math.PI) / 180, camera.aspect, camera.near, camera.far, offset, this.convergence);
    this.eye.matrixAutoUpdate = false;
    this.eye.matrix.copy(camera.matrixWorld).multiply(new three.Matrix4().makeTranslation(offset, 0, 0));
    this.eye.matrixWorld.copy(this.eye.matrix);
    this.eye.matrixWorldInverse.copy(this.eye.matrix).invert();
    this.eye.matrixWorldAutoUpdate = false;
    this.eye.near = camera.near;
    this.eye.far = camera.far;
    this.eye.projectionMatrix.makePerspective(f.left, f.right, f.top, f.bottom, f.near, f.far);
    this.eye.projectionMatrixInverse.copy(this.eye.projectionMatrix).invert();
    return this.eye;
  }

  private target(n: number, width: number, height: number): EyeTarget {
    const old = this.eyes[n];
    if (old && old.color.width === width && old.color.height === height) return old;
    old?.color.dispose();
    old?.shade.dispose();
    const color = new three.WebGLRenderTarget(width, height, {
      type: three.HalfFloatType, samples: this.software ? 0 : 4, depthTexture: new three.DepthTexture(width, height),
    });
    const shade = new three.WebGLRenderTarget(Math.ceil(width / 2), Math.ceil(height / 2),
                                              { depthBuffer: false, minFilter: three.LinearFilter });
    this.eyes[n] = { color, shade };
    return this.eyes[n];
  }

  private render(n: number, scene: three.Scene, camera: three.PerspectiveCamera, width: number, height: number,
              radius: number) {
    const target = this.target(n, width, height);
    this.renderer.setRenderTarget(target.color);
    this.renderer.render(scene, camera);
    if (!this.occlusion) return;
    const u = this.occlude.uniforms, p = camera.projectionMatrix.elements;
    u.depth.value = target.color.depthTexture;
    u.unproject.value.identity();
    u.unproject.value.elements[0] = 1 / p[0];
    u.unproject.value.elements[5] = 1 / p[5];
    u.pixel.value.set(2 / width, 2 / height);
    u.near.value = camera.near;
    u.far.value = camera.far;
    u.radius.value = radius;
    u.perUnit.value = 0.5 * p[5];
    this.pass(this.occlude, target.shade);
  }

  private show(left: number, right: number, x: number, y: number, width: number, height: number) {
    const u = this.finish.uniforms;
    u.left.value = this.eyes[left].color.texture;
    u.right.value = this.eyes[right].color.texture;
    u.shade.value = this.eyes[left].shade.texture;
    u.shadeRight.value = this.eyes[right].shade.texture;
    u.pixel.value.set(2 / width, 2 / height);
    u.anaglyph.value = left !== right;
    u.shaded.value = this.occlusion;
    const ratio = this.renderer.getPixelRatio();
    this.renderer.setViewport(x / ratio, y / ratio, width / ratio, height / ratio);
    this.pass(this.finish, null);
    const whole = this.renderer.getSize(new three.Vector2());
    this.renderer.setViewport(0, 0, whole.x, whole.y);
  }

  private pass(material: three.ShaderMaterial, target: three.WebGLRenderTarget | null) {
    this.quad.material = material;
    this.renderer.setRenderTarget(target);
    this.renderer.autoClear = false;
    this.renderer.render(this.screen, this.flat);
    this.renderer.autoClear = true;
  }
}
