import { Blocks } from './Blocks';

export default function Page() {
  return <Blocks />;
}
