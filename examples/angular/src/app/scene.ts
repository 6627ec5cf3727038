import { Component, CUSTOM_ELEMENTS_SCHEMA, input, NO_ERRORS_SCHEMA, output } from '@angular/core';
import { startOf, type Block } from './block';

/** Custom elements need the first schema, x3dom's tags without a hyphen the second. */
@Component({
  selector: 'app-scene',
  schemas: [CUSTOM_ELEMENTS_SCHEMA, NO_ERRORS_SCHEMA],
  templateUrl: './scene.html',
  styles: ':host { display: contents; }',
})
export class Scene {
  readonly blocks = input.required<Block[]>();
  readonly lamp = input.required<boolean>();
  readonly hit = output<number>();

  protected readonly startOf = startOf;
}
