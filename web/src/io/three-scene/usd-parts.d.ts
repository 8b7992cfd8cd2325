// Parts of three's loader of USD that its types leave out.

declare module "three/examples/jsm/loaders/usd/USDComposer.js" {
  export class USDComposer {
    compose(layer: object, assets?: object, ...rest: unknown[]): unknown;
  }
}

declare module "three/examples/jsm/loaders/usd/USDCParser.js" {
  export class USDCParser {}
}
